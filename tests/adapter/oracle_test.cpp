// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The oracle over a tracer that does what it should: order, kinds, parts, pipelining, time.
#include <sys/time.h>

#include <csignal>

#include "tests/adapter/oracle_fixture.h"

namespace povpreview {
namespace {

constexpr Parts everything = Parts::surface | Parts::shading | Parts::signature;

TEST_F(OracleTest, DescribesTheScene) {
    PovrayOracle oracle(fake_tracer({}));
    std::vector<std::uint64_t> steps;
    const SceneDescription& scene =
        oracle.wait_for_scene([&](const report::Progress& p) { steps.push_back(p.done); }, nullptr);
    EXPECT_EQ(steps, (std::vector<std::uint64_t>{0, 1, 2}));
    EXPECT_EQ(scene.width, fake::width);
    EXPECT_EQ(scene.height, fake::height);
    EXPECT_FLOAT_EQ(scene.working_gamma, 2.2F);
    EXPECT_TRUE(scene.antialias);
    EXPECT_EQ(scene.camera.location, glm::dvec3(1, 2, -5));
    EXPECT_EQ(scene.camera.angle, 67.5);
    EXPECT_EQ(scene.camera.blur_samples, 30U);
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.lights[0].kind, LightKind::area);
    EXPECT_EQ(scene.lights[0].area_columns, 5U);
    EXPECT_TRUE(scene.has("reflection"));
    EXPECT_FALSE(scene.has("radiosity"));
    ASSERT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(scene.objects[0].kind, "sphere");
    EXPECT_EQ(scene.background, glm::vec3(.25, .5, .75));
    EXPECT_EQ(oracle.tracer().threads, 2U);
}

TEST_F(OracleTest, EveryKindBringsItsParts) {
    PovrayOracle oracle(fake_tracer({}));
    for (const RayKind kind : {RayKind::full, RayKind::probe, RayKind::albedo})
        for (unsigned bits = 0; bits < 8; ++bits) {
            const auto parts = static_cast<Parts>(bits);
            expect_right(trace(oracle, all_pixels(kind), parts), all_pixels(kind), parts);
        }
    const std::uint64_t each = 8 * all_pixels().size();
    EXPECT_EQ(oracle.statistics().of(RayKind::full), each);
    EXPECT_EQ(oracle.statistics().of(RayKind::probe), each);
    EXPECT_EQ(oracle.statistics().of(RayKind::albedo), each);
    EXPECT_EQ(oracle.statistics().failed, 0U);
    EXPECT_TRUE(oracle.faults().empty());
}

TEST_F(OracleTest, AnswersComeInTheOrderOfRequestsWhateverTheOrderOfSlices) {
    constexpr unsigned seed = 20261121;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    PovrayOracle oracle(fake_tracer({"shuffle", "slice=7"}));
    std::vector<Request> asked;
    std::vector<Sample> samples;
    for (int round = 0; round < 200; ++round) {
        std::vector<Request> requests(random() % 300);
        for (Request& r : requests)
            r = {{std::uniform_real_distribution<>(-9, 70)(random),
                  std::uniform_real_distribution<>(-9, 50)(random)},
                 static_cast<RayKind>(random() % 3)};
        oracle.submit(requests, everything);
        asked.insert(asked.end(), requests.begin(), requests.end());
        oracle.collect(samples, std::chrono::microseconds(random() % 500));
    }
    for (int i = 0; samples.size() < asked.size() && i < 1000; ++i) oracle.collect(samples, 20ms);
    expect_right(samples, asked, everything);
}

TEST_F(OracleTest, ABatchLargerThanTheWireAllowsIsCut) {
    PovrayOracle oracle(fake_tracer({"slice=1000"}));
    std::vector<Request> requests;
    for (int i = 0; i < 3; ++i)
        for (int y = 0; y < 300; ++y)
            for (int x = 0; x < 300; ++x) requests.push_back({{x / 8. + i, y / 8.}, RayKind::full});
    expect_right(trace(oracle, requests, everything), requests, everything);
}

TEST_F(OracleTest, NothingDueMeansNoWait) {
    PovrayOracle oracle(fake_tracer({}));
    oracle.wait_for_scene(nullptr, nullptr);
    const auto start = std::chrono::steady_clock::now();
    std::vector<Sample> samples;
    oracle.collect(samples, 5s);
    oracle.submit({}, Parts::colour);
    oracle.collect(samples, 5s);
    EXPECT_LT(std::chrono::steady_clock::now() - start, 1s);
    EXPECT_TRUE(samples.empty());
}

TEST_F(OracleTest, PatienceIsKept) {
    PovrayOracle oracle(fake_tracer({"delay_us=3000000"}));
    oracle.wait_for_scene(nullptr, nullptr);
    oracle.submit(all_pixels(), Parts::colour);
    std::vector<Sample> samples;
    const auto start = std::chrono::steady_clock::now();
    oracle.collect(samples, 200ms);
    const auto waited = std::chrono::steady_clock::now() - start;
    EXPECT_GE(waited, 200ms);
    EXPECT_LT(waited, 600ms);
    EXPECT_TRUE(samples.empty());
    EXPECT_GT(oracle.statistics().busy, .5);
}

extern "C" void ignore_alarm(int) {}

TEST_F(OracleTest, ASignalEndsTheWaitAndHarmsNothing) {
    struct sigaction action {
    }, before{};
    action.sa_handler = ignore_alarm;
    sigaction(SIGALRM, &action, &before);
    PovrayOracle oracle(fake_tracer({"delay_us=2000"}));
    oracle.wait_for_scene(nullptr, nullptr);
    const itimerval often{.it_interval = {0, 1000}, .it_value = {0, 1000}};
    setitimer(ITIMER_REAL, &often, nullptr);
    const std::vector<Sample> samples = trace(oracle, all_pixels(), everything);
    const itimerval never{};
    setitimer(ITIMER_REAL, &never, nullptr);
    sigaction(SIGALRM, &before, nullptr);
    expect_right(samples, all_pixels(), everything);
    EXPECT_EQ(oracle.statistics().restarts, 0U);
}

TEST_F(OracleTest, SubmittingBeforeTheSceneIsThere) {
    PovrayOracle oracle(fake_tracer({"parse=slow"}));
    expect_right(trace(oracle, all_pixels(), everything), all_pixels(), everything);
}

TEST_F(OracleTest, AFailedSampleIsFailedAloneAndADepthThatIsNoneIsAFailure) {
    PovrayOracle oracle(fake_tracer({"fail_at=3,4", "nan_at=5,6"}));
    expect_right(
        trace(oracle, all_pixels(), everything), all_pixels(), everything, [](const Sample& s) {
            return s.position == glm::dvec2(3.5, 4.5) || s.position == glm::dvec2(5.5, 6.5);
        });
    EXPECT_EQ(oracle.statistics().failed, 2U);
    EXPECT_EQ(oracle.statistics().restarts, 0U);
}

TEST_F(OracleTest, ManyOrdersDoNotDeadlockWithManyAnswers) {
    // Far more in flight both ways than the socket's buffers hold, and nothing collected meanwhile.
    PovrayOracle oracle(fake_tracer({"slice=512"}));
    std::vector<Request> requests, asked;
    for (int i = 0; i < 20000; ++i) requests.push_back({{i % 64 + .25, i / 64 % 48 + .25}});
    for (int i = 0; i < 20; ++i) {
        oracle.submit(requests, everything);
        asked.insert(asked.end(), requests.begin(), requests.end());
    }
    std::vector<Sample> samples;
    for (int i = 0; samples.size() < asked.size() && i < 2000; ++i) oracle.collect(samples, 20ms);
    expect_right(samples, asked, everything);
}

// ---- the ladder of accuracy

std::vector<Request> on_rung(std::vector<Request> requests, Rung rung) {
    for (Request& request : requests) request.rung = rung;
    return requests;
}

void expect_on_rung(const std::vector<Sample>& samples, Rung rung) {
    for (const Sample& sample : samples) {
        const glm::vec3 target = fake::sample_at(sample.position).colour;
        ASSERT_EQ(sample.colour, target * fake::rung_scale(rung));
        ASSERT_EQ(sample.rung, rung);
    }
}

TEST_F(OracleTest, SamplesOfLowerRungsComeBeforeTheTargetIsReady) {
    PovrayOracle oracle(fake_tracer({"target_after=6000"}));
    EXPECT_EQ(oracle.wait_for_scene(nullptr, nullptr).ladder.rungs.size(), 3U);
    EXPECT_FALSE(oracle.target_ready());
    expect_on_rung(trace(oracle, on_rung(all_pixels(), 0), Parts::colour), 0);
    EXPECT_FALSE(oracle.target_ready());
    expect_on_rung(trace(oracle, on_rung(all_pixels(), 1), Parts::colour), 1);
    expect_on_rung(trace(oracle, all_pixels(), Parts::colour), target_rung);
    EXPECT_TRUE(oracle.target_ready());
}

TEST_F(OracleTest, TheTargetIsWaitedForAndProbesAreNot) {
    PovrayOracle oracle(fake_tracer({"target_after=3000"}));
    oracle.wait_for_scene(nullptr, nullptr);
    std::vector<Request> mixed = all_pixels(RayKind::probe);
    const std::vector<Request> full = all_pixels();
    mixed.insert(mixed.end(), full.begin(), full.end());
    const std::vector<Sample> samples = trace(oracle, mixed, everything);
    EXPECT_TRUE(oracle.target_ready());
    expect_right(samples, mixed, everything);
}

TEST_F(OracleTest, ATracerThatDiesBeforeOrAfterItsTargetIsReadyIsReplaced) {
    // The second tracer's target is ready after as many answers of its own; so many are left.
    for (const char* death : {"die_after=1500", "die_after=4000"}) {
        PovrayOracle oracle(fake_tracer({"target_after=2000", death, "once=" + fresh_file()}));
        oracle.wait_for_scene(nullptr, nullptr);
        std::vector<Request> mixed = on_rung(all_pixels(), 1);
        const std::vector<Request> full = all_pixels(), probes = all_pixels(RayKind::probe);
        mixed.insert(mixed.end(), full.begin(), full.end());
        mixed.insert(mixed.end(), probes.begin(), probes.end());
        const std::vector<Sample> samples = trace(oracle, mixed, Parts::colour);
        ASSERT_EQ(samples.size(), mixed.size());
        EXPECT_EQ(oracle.statistics().restarts, 1U);
        const std::size_t n = full.size();
        expect_on_rung({samples.begin(), samples.begin() + std::ptrdiff_t(n)}, 1);
        expect_on_rung(
            {samples.begin() + std::ptrdiff_t(n), samples.begin() + std::ptrdiff_t(2 * n)},
            target_rung);
    }
}

}  // namespace
}  // namespace povpreview
