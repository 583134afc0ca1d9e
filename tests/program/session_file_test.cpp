// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/session_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <fstream>
#include <iterator>
#include <random>

#include "core/error.h"
#include "display/program/session_samples.h"
#include "tests/display/temporary_folder.h"

namespace povpreview {
namespace {

std::vector<Sample> random_samples(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(-2, 2);
    const auto vector = [&] { return glm::vec3(number(random), number(random), number(random)); };
    std::vector<Sample> result;
    for (std::size_t i = 0; i < count; ++i) {
        Sample s;
        s.position = {random() % 1000 / 8., number(random)};
        s.kind = static_cast<RayKind>(random() % 3);
        s.parts = static_cast<Parts>(random() % 8);
        const bool full = s.kind == RayKind::full;
        s.failed = random() % 10 == 0;
        s.cost_ns = static_cast<std::uint32_t>(random());
        const auto has = [&](bool always, Parts part) {
            return !s.failed && (always || (full && contains(s.parts, part)));
        };
        if (full && !s.failed) s.colour = vector(), s.transmittance = number(random);
        if (has(!full, Parts::surface))
            s.surface = static_cast<std::uint32_t>(random()), s.reflected_surface = s.surface + 1,
            s.depth = 3, s.normal = vector();
        if (has(s.kind == RayKind::albedo, Parts::shading)) s.albedo = vector();
        if (has(false, Parts::shading)) s.illumination = vector(), s.remainder = vector();
        if (has(s.kind == RayKind::probe, Parts::signature))
            s.signature = {1, static_cast<std::uint32_t>(random()), 3, 4};
        result.push_back(s);
    }
    return result;
}

bool equal(const Sample& p, const Sample& q) {
    return p.parts == q.parts && p.position == q.position && p.kind == q.kind &&
           p.failed == q.failed && p.colour == q.colour && p.transmittance == q.transmittance &&
           p.surface == q.surface && p.reflected_surface == q.reflected_surface &&
           p.depth == q.depth && p.normal == q.normal && p.albedo == q.albedo &&
           p.illumination == q.illumination && p.remainder == q.remainder &&
           p.signature == q.signature && p.cost_ns == q.cost_ns;
}

class SessionFileTest : public testing::Test {
   protected:
    void SetUp() override {
        std::ofstream(folder_.path() / "a.pov") << "sphere { 0, 1 }\n";
        std::ofstream(folder_.path() / "b.inc") << "#declare B = 1;\n";
        identity_ = {"3.7.0.10",
                     64,
                     48,
                     false,
                     {"a.pov", "+W64"},
                     {folder_.path() / "a.pov", folder_.path() / "b.inc"}};
    }
    std::filesystem::path file() const { return folder_.path() / "s"; }
    std::string bytes() const {
        std::ifstream stream(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }
    void set_bytes(const std::string& to) const {
        std::ofstream(file(), std::ios::binary | std::ios::trunc) << to;
    }
    /// Begins a session of these samples in chunks of ten.
    void keep(const std::vector<Sample>& samples) const {
        SessionFile session = SessionFile::begin(file(), identity_);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            session.add(samples[i]);
            if (i % 10 == 9) session.write_all();
        }
    }
    std::vector<Sample> resumed() const {
        std::vector<Sample> result;
        SessionFile::resume(file(), identity_, [&](const Sample& s) { result.push_back(s); });
        return result;
    }
    std::string refusal() const {
        try {
            resumed();
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::usage);
            return error.what();
        }
        return "";
    }

    test::TemporaryFolder folder_;
    SessionIdentity identity_;
};

TEST_F(SessionFileTest, GivesBackWhatItWasGiven) {
    constexpr unsigned seed = 1;
    const std::vector<Sample> samples = random_samples(seed, 95);
    keep(samples);
    std::vector<Sample> back = resumed();
    ASSERT_EQ(back.size(), samples.size());
    for (std::size_t i = 0; i < back.size(); ++i) EXPECT_TRUE(equal(back[i], samples[i])) << i;
    // And goes on.
    SessionFile::resume(file(), identity_, [](const Sample&) {}).add(samples[3]);
    back = resumed();
    ASSERT_EQ(back.size(), samples.size() + 1);
    EXPECT_TRUE(equal(back.back(), samples[3]));
}

TEST_F(SessionFileTest, CutOffAnywhereItHasAllWholeChunksOrIsRefused) {
    const std::vector<Sample> samples = random_samples(2, 30);
    keep(samples);
    const std::string whole = bytes();
    std::size_t before = 0;
    for (std::size_t size = 0; size <= whole.size(); size += size < 200 ? 1 : 7) {
        set_bytes(whole.substr(0, size));
        std::vector<Sample> back;
        try {
            back = resumed();
        } catch (const Error&) {
            EXPECT_EQ(before, 0U) << size;
            continue;
        }
        EXPECT_TRUE(back.size() % 10 == 0 && back.size() >= before) << size;
        for (std::size_t i = 0; i < back.size(); ++i) ASSERT_TRUE(equal(back[i], samples[i]));
        before = back.size();
        // What is added takes the place of what was cut off.
        SessionFile::resume(file(), identity_, [](const Sample&) {}).add(samples[0]);
        EXPECT_EQ(resumed().size(), before + 1) << size;
    }
    EXPECT_GE(before, 20U);
}

TEST_F(SessionFileTest, DamagedAnywhereItIsRefusedOrShorterNeverWrong) {
    const std::vector<Sample> samples = random_samples(3, 30);
    keep(samples);
    const std::string whole = bytes();
    std::size_t refused = 0, tried = 0;
    for (std::size_t at = 0; at < whole.size(); at += 5) {
        std::string broken = whole;
        broken[at] = static_cast<char>(broken[at] ^ 0x40);
        set_bytes(broken);
        ++tried;
        try {
            const std::vector<Sample> back = resumed();
            ASSERT_LT(back.size(), samples.size()) << at;
            for (std::size_t i = 0; i < back.size(); ++i) ASSERT_TRUE(equal(back[i], samples[i]));
        } catch (const Error& error) {
            ++refused;
            EXPECT_NE(std::string(error.what()).find("session"), std::string::npos) << at;
        }
    }
    EXPECT_GT(refused, tried * 9 / 10);
}

TEST_F(SessionFileTest, IsRefusedWhereItIsOfSomethingElseAndSaysOfWhat) {
    keep(random_samples(4, 5));
    EXPECT_EQ(refusal(), "");
    const SessionIdentity right = identity_;
    identity_.words.back() = "+W65";
    EXPECT_NE(refusal().find("+W64"), std::string::npos) << refusal();
    identity_ = right;
    identity_.words.push_back("Declare=Radiosity=1");
    EXPECT_NE(refusal().find("Declare=Radiosity=1"), std::string::npos) << refusal();
    identity_ = right;
    identity_.alpha = true;
    EXPECT_NE(refusal().find("alpha"), std::string::npos) << refusal();
    identity_ = right;
    std::ofstream(folder_.path() / "b.inc") << "#declare B = 2;\n";
    EXPECT_NE(refusal().find("b.inc has changed"), std::string::npos) << refusal();
    set_bytes("no session at all");
    EXPECT_NE(refusal().find("no session"), std::string::npos) << refusal();
    std::filesystem::remove(file());
    EXPECT_NE(refusal().find("No such file"), std::string::npos) << refusal();
}

TEST_F(SessionFileTest, OneAtATimeAndNeverOverAnother) {
    const SessionFile first = SessionFile::begin(file(), identity_);
    EXPECT_NE(refusal().find("another povpreview"), std::string::npos) << refusal();
    EXPECT_THROW(SessionFile::begin(file(), identity_), Error);
    EXPECT_THROW(SessionFile::begin("/proc/nowhere/s", identity_), Error);
}

TEST_F(SessionFileTest, AFullDiskEndsTheKeepingAndLosesNothingKept) {
    const std::vector<Sample> samples = random_samples(5, 200);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, SIG_IGN);
    {
        SessionFile session = SessionFile::begin(file(), identity_);
        for (std::size_t i = 0; i < 100; ++i) session.add(samples[i]);
        session.write_all();
        const rlimit limit{std::filesystem::file_size(file()) + 100, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
        for (std::size_t i = 100; i < 200; ++i) session.add(samples[i]);
        session.write_all();
        EXPECT_NE(session.trouble().find("kept"), std::string::npos);
        setrlimit(RLIMIT_FSIZE, &before);
    }
    signal(SIGXFSZ, SIG_DFL);
    EXPECT_EQ(resumed().size(), 100U);
}

}  // namespace
}  // namespace povpreview
