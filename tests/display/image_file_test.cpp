// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/image_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <random>

#include "core/colour.h"
#include "core/error.h"
#include "display/atomic_file.h"
#include "tests/display/temporary_folder.h"

namespace povpreview::test {
namespace {

namespace fs = std::filesystem;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// The value that one channel has in the file, as an integer of `most` steps.
int stored(float linear, FileFormat format, int most) {
    const TemporaryFolder folder;
    write_image(Image(1, 1, glm::vec3(linear)), folder / "a.png", format);
    const Image image = read_image(folder / "a.png");
    return static_cast<int>(std::lround(image.at(0, 0).x * static_cast<float>(most)));
}

TEST(ImageFile, EveryPng16ValueComesBackExactly) {
    const TemporaryFolder folder;
    Image image(256, 256);
    for (int code = 0; code < 65536; ++code)
        image.pixels[static_cast<std::size_t>(code)] =
            glm::vec3(decode_srgb(static_cast<float>(code) / 65535.f));
    write_image(image, folder / "a.png");
    const Image back = read_image(folder / "a.png");
    ASSERT_EQ(back.width, 256);
    ASSERT_EQ(back.height, 256);
    for (int code = 0; code < 65536; ++code)
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(std::lround(back.pixels[static_cast<std::size_t>(code)][c] * 65535.f), code);
}

TEST(ImageFile, JpegIsCloseAlsoAtColouredEdges) {
    const TemporaryFolder folder;
    Image image(64, 48, glm::vec3(decode_srgb(.8f), 0, 0));
    for (int y = 0; y < image.height; ++y)
        for (int x = 31; x < image.width; ++x) image.at(x, y) = glm::vec3(0, 0, decode_srgb(.7f));
    const std::vector<unsigned char> bytes = encoded_image(image, FileFormat::jpeg);
    EXPECT_LT(bytes.size(), 4000u);
    write_file(folder / "a.jpg", bytes);
    const Image back = read_image(folder / "a.jpg");
    ASSERT_EQ(back.pixels.size(), image.pixels.size());
    for (std::size_t i = 0; i < back.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(back.pixels[i][c], display_encoded(image.pixels[i])[c], .05) << i;
}

TEST(ImageFile, RoundsHalvesUpAsPovRay) {
    // straight part of the curve: encoded = 12.92 linear, exactly half way between two codes
    const float half_way = 20.5f / 65535.f / 12.92f;
    EXPECT_EQ(stored(std::nextafter(half_way, 0.f) * .9999f, FileFormat::png16, 65535), 20);
    EXPECT_EQ(stored(half_way * 1.0001f, FileFormat::png16, 65535), 21);
    EXPECT_EQ(stored(.5f, FileFormat::png8, 255), 188);
    EXPECT_EQ(stored(.5f, FileFormat::png16, 65535), 48192);
}

TEST(ImageFile, PngClampsWhatNoDisplayShows) {
    for (const FileFormat format : {FileFormat::png8, FileFormat::png16}) {
        const int most = format == FileFormat::png8 ? 255 : 65535;
        EXPECT_EQ(stored(not_a_number, format, most), 0);
        EXPECT_EQ(stored(-not_a_number, format, most), 0);
        EXPECT_EQ(stored(infinity, format, most), most);
        EXPECT_EQ(stored(-infinity, format, most), 0);
        EXPECT_EQ(stored(-1, format, most), 0);
        EXPECT_EQ(stored(7, format, most), most);
        EXPECT_EQ(stored(1, format, most), most);
        EXPECT_EQ(stored(0, format, most), 0);
    }
}

TEST(ImageFile, ExrKeepsEveryValue) {
    const TemporaryFolder folder;
    Image image(5, 1);
    image.pixels = {{-1, 0, 7.123456f}, {1e30f, 1e-30f, .1f}, {infinity, -infinity, 0}, {}, {}};
    image.pixels[3] = glm::vec3(not_a_number);
    write_image(image, folder / "a.exr", FileFormat::exr_float);
    const Image back = read_image(folder / "a.exr");
    for (const std::size_t i : {0, 1, 2, 4}) EXPECT_EQ(back.pixels[i], image.pixels[i]);
    EXPECT_TRUE(std::isnan(back.pixels[3].x));

    write_image(Image(1, 1, {.5f, 2, -3}), folder / "half.exr");
    EXPECT_EQ(read_image(folder / "half.exr").at(0, 0), glm::vec3(.5f, 2, -3));
}

TEST(ImageFile, ChannelsAndRowsStayInTheirPlaces) {
    const TemporaryFolder folder;
    Image image(3, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) image.at(x, y) = {x == 2, y == 1, x == 0};
    for (const char* name : {"a.png", "a.exr"}) {
        write_image(image, folder / name);
        EXPECT_EQ(read_image(folder / name).pixels, image.pixels) << name;
    }
}

TEST(ImageFile, TheNameChoosesTheFormat) {
    EXPECT_EQ(format_for("a/b.png"), FileFormat::png16);
    EXPECT_EQ(format_for("B.PNG"), FileFormat::png16);
    EXPECT_EQ(format_for("x.exr"), FileFormat::exr_half);
    for (const char* name : {"a", "png", ".png", "a.jpg", "a.png.txt", ""}) {
        try {
            format_for(name);
            ADD_FAILURE() << name << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::usage);
        }
    }
}

TEST(ImageFile, WhatCannotBeReadIsAnErrorWithThePath) {
    const TemporaryFolder folder;
    std::ofstream(folder / "empty.png");
    std::ofstream(folder / "text.png") << "this is no picture";
    write_image(Image(64, 64, {.2f, .3f, .4f}), folder / "whole.png");
    fs::copy(folder / "whole.png", folder / "cut.png");
    fs::resize_file(folder / "cut.png", fs::file_size(folder / "whole.png") / 2);
    for (const char* name : {"none.png", "empty.png", "text.png", "cut.png"}) {
        try {
            read_image(folder / name);
            ADD_FAILURE() << name << " was read";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find((folder / name).string()), std::string::npos);
            EXPECT_EQ(error.exit(), Exit::usage);
        }
    }
}

class AtomicFile : public testing::Test {
   protected:
    static std::string content(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    static void write(const fs::path& path, const std::string& text) {
        write_file(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    }
    /// The message of the Error that writing there gives.
    static std::string failure(const fs::path& path) {
        try {
            write(path, "new");
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::usage);
            return error.what();
        }
        ADD_FAILURE() << path << " was written";
        return "";
    }

    const TemporaryFolder folder;
};

TEST_F(AtomicFile, WritesAndReplaces) {
    write(folder / "a", "first");
    EXPECT_EQ(content(folder / "a"), "first");
    write(folder / "a", "");
    EXPECT_EQ(content(folder / "a"), "");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST_F(AtomicFile, KeepsPermissionsAndFollowsLinks) {
    write(folder / "a", "old");
    fs::permissions(folder / "a", fs::perms(0640));
    fs::create_symlink("a", folder / "link");
    write(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(content(folder / "a"), "new");
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
}

TEST_F(AtomicFile, ImpossiblePlacesAreErrorsWithPathAndRemedy) {
    write(folder / "file", "x");
    for (const char* place : {"none/a", "file/a"}) {
        const std::string message = failure(folder / place);
        EXPECT_NE(message.find((folder / place).string()), std::string::npos) << message;
        EXPECT_NE(message.find("folder"), std::string::npos) << message;
    }
    EXPECT_NE(failure(folder.path()).find(folder.path().string()), std::string::npos);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST_F(AtomicFile, AFullDeviceIsAnError) {
    EXPECT_NE(failure("/dev/full").find("room"), std::string::npos);
    EXPECT_TRUE(fs::is_character_file("/dev/full")) << "the device must not be replaced";
}

/// Lets this process write no more than `bytes` into a file, as a full disk would.
class FileSizeLimit {
   public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limited{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limited);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

   private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST_F(AtomicFile, AFailureInTheMiddleLeavesTheOldFileAndNothingElse) {
    Image noise(200, 200);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> shade(0, 1);
    for (glm::vec3& colour : noise.pixels) colour = {shade(random), shade(random), shade(random)};
    for (const char* name : {"a.png", "a.exr"}) {
        write(folder / name, "old");
        bool failed = false;
        {
            const FileSizeLimit limit(10000);
            try {
                write_image(noise, folder / name);
            } catch (const Error& error) {
                failed = true;
                EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
            }
        }
        EXPECT_TRUE(failed) << name;
        EXPECT_TRUE(content(folder / name) == "old") << name;
    }
    EXPECT_EQ(folder.entries(), 2u) << "only the two old files";
}

/// An image with every kind of value, written and annotated.
AnnotatedImage annotated(FileFormat format, const std::string& name) {
    Image image(3, 2, glm::vec3(.25f, .5f, .125f));
    image.at(1, 0) = {infinity, 0, 1};
    image.at(2, 1) = {0, not_a_number, 1};
    return annotated_image(encoded_image(image, format),
                           {{"Software", "ours 1"}, {"Command", "do \"this\""}}, name);
}

TEST(ImageFile, NotesChangeNoValue) {
    const TemporaryFolder folder;
    for (const auto& [format, name] : {std::pair{FileFormat::png8, "a.png"},
                                       {FileFormat::png16, "a.png"},
                                       {FileFormat::exr_half, "a.exr"},
                                       {FileFormat::exr_float, "a.exr"}}) {
        Image image(3, 2, glm::vec3(.25f, .5f, .125f));
        write_image(image, folder / name, format);
        const Image plain = read_image(folder / name);
        write_file(folder / name,
                   annotated_image(encoded_image(image, format), {{"Title", "t"}}, name).bytes);
        const Image noted = read_image(folder / name);
        EXPECT_EQ(noted.width, 3);
        EXPECT_EQ(noted.height, 2);
        EXPECT_EQ(noted.pixels, plain.pixels) << name;
    }
}

TEST(ImageFile, NotesStandInTheFileAndMakeNoDifferenceOfTheirOwn) {
    for (const auto& [format, name] :
         {std::pair{FileFormat::png16, "a.png"}, {FileFormat::exr_half, "a.exr"}}) {
        const AnnotatedImage one = annotated(format, name);
        const std::string bytes(one.bytes.begin(), one.bytes.end());
        EXPECT_NE(bytes.find("ours 1"), std::string::npos) << name;
        EXPECT_NE(bytes.find("do \"this\""), std::string::npos) << name;
        sleep(1);  // a time of day in the file would differ
        EXPECT_EQ(annotated(format, name).bytes, one.bytes) << name;
    }
}

TEST(ImageFile, WhatIsNotFiniteIsCountedInPixels) {
    EXPECT_EQ(annotated(FileFormat::exr_half, "a.exr").not_finite, 2U);
    EXPECT_EQ(annotated(FileFormat::exr_float, "a.exr").not_finite, 2U);
    EXPECT_EQ(annotated(FileFormat::png16, "a.png").not_finite, 0U);
    const unsigned char garbage[] = {1, 2, 3};
    EXPECT_THROW(annotated_image(garbage, {}, "a.png"), Error);
}

}  // namespace
}  // namespace povpreview::test
