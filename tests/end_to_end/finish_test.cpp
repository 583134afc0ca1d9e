// SPDX-License-Identifier: AGPL-3.0-or-later
//
// povpreview --finish against stock POV-Ray, an independent program, given the same words: the same
// file, with the same pixels.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/end_to_end/real_tracer.h"
#include "tests/end_to_end/scenes.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

struct Finish {
    const char* name;
    const char* scene;  ///< of scenes::still
    const char* words;
    const char* file;
    double tolerance = 1. / 255;  ///< worst difference of a value, full scale 1
};

void PrintTo(const Finish& finish, std::ostream* out) { *out << finish.name; }

struct ImageFile {
    OIIO::ImageSpec spec;
    std::vector<float> values;
};

ImageFile read(const fs::path& file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) throw std::runtime_error("cannot read " + file.string());
    ImageFile image{input->spec(), {}};
    image.values.resize(image.spec.image_pixels() * static_cast<std::size_t>(image.spec.nchannels));
    input->read_image(0, 0, 0, image.spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data());
    return image;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

class FinishTest : public testing::TestWithParam<Finish> {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
        for (const char* name : {"ours", "stock"}) fs::create_directory(folder_.path() / name);
        setenv("POVPREVIEW_TRACER", real_tracer().c_str(), 1);
    }
    /// Runs a command in one of the two folders; its messages go to a file there.
    int run(const std::string& in, const std::string& command) const {
        return std::system(("cd " + (folder_.path() / in).string() + " && timeout 120 " + command +
                            " > messages 2>&1")
                               .c_str());
    }
    void write_scene(const std::string& name) const {
        for (const scenes::SmallScene& scene : scenes::still)
            if (name == scene.name)
                for (const char* in : {"ours", "stock"})
                    std::ofstream(folder_.path() / in / "scene.pov") << scene.text;
    }
    WorkFolder folder_;
};

TEST_P(FinishTest, TheFileIsTheOneThatStockPovrayMakes) {
    const Finish& finish = GetParam();
    write_scene(finish.scene);
    const std::string words = std::string(" scene.pov +W80 +H60 ") + finish.words;
    ASSERT_EQ(run("stock", "povray -D" + words), 0);
    ASSERT_EQ(run("ours", std::string(POVPREVIEW) + words + " --headless --finish"), 0)
        << bytes_of(folder_.path() / "ours/messages");
    const fs::path ours = folder_.path() / "ours" / finish.file,
                   stock = folder_.path() / "stock" / finish.file;
    ASSERT_TRUE(fs::exists(stock)) << "the test is wrong about POV-Ray's file";
    ASSERT_TRUE(fs::exists(ours)) << bytes_of(folder_.path() / "ours/messages");
    // Nothing else: no preview beside it, no state file.
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path() / "ours"), {}), 3);

    const ImageFile a = read(ours), b = read(stock);
    ASSERT_EQ(a.spec.width, b.spec.width);
    ASSERT_EQ(a.spec.height, b.spec.height);
    ASSERT_EQ(a.spec.nchannels, b.spec.nchannels);
    EXPECT_EQ(a.spec.format, b.spec.format);
    double worst = 0;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double off = std::abs(a.values[i] - b.values[i]) / std::max(1.F, b.values[i]);
        worst = std::max(worst, off);
        differing += off > finish.tolerance;
    }
    EXPECT_EQ(differing, 0U) << "worst " << worst;
    EXPECT_GT(*std::max_element(b.values.begin(), b.values.end()), .3F) << "an empty picture";
}

constexpr double deep = 2. / 65535;
const Finish finishes[] = {
    {"plain", "mirror_and_glass", "-A", "scene.png"},
    {"method_1", "mirror_and_glass", "+A0.1 +FN16", "scene.png", deep},
    {"method_1_without_jitter", "layers_and_maps", "+A0.05 -J +R2 +FN16", "scene.png", deep},
    {"method_1_before_gamma", "before_gamma", "+A0.1 +R4 +J0.5", "scene.png"},
    {"method_2", "mirror_and_glass", "+AM2 +A0.1 +R3 +FN16", "scene.png", deep},
    {"method_2_without_jitter", "fog_and_iridescence", "+AM2 +A0.05 -J", "scene.png"},
    {"focal_blur", "focal_blur", "+A0.2 +R2", "scene.png"},
    {"alpha_named", "fisheye", "+A +UA +FN16 +Oother.png", "other.png", deep},
    {"alpha_of_glass", "layers_and_maps", "+UA +AM2 +A0.1 -J +FN", "scene.png"},
    {"targa", "mirror_and_glass", "+A +FT -J", "scene.tga"},
    {"ppm", "before_gamma", "+FP16 +Onamed", "named.ppm", deep},
    {"bmp_with_gamma", "mirror_and_glass", "+FB File_Gamma=1.8", "scene.bmp"},
    {"half_floats", "mirror_and_glass", "+FE +A0.1", "scene.exr", 1e-3},
    {"radiance", "layers_and_maps", "+FH", "scene.hdr", 1e-2},
    {"grey_and_dithered", "mirror_and_glass", "+FN Grayscale_Output=on Dither=on Dither_Method=B2",
     "scene.png"},
    {"mosaic_asked_for", "mirror_and_glass", "+SP16 +EP4 +A0.1", "scene.png"},
    {"part_of_the_image", "mirror_and_glass", "+SC0.25 +EC0.75 +SR11 +ER50 +A0.1", "scene.png"},
    {"low_quality", "mirror_and_glass", "+Q4 +A0.1", "scene.png"},
};

INSTANTIATE_TEST_SUITE_P(Files, FinishTest, testing::ValuesIn(finishes),
                         [](const auto& finish) { return finish.param.name; });

}  // namespace
}  // namespace povpreview
