// SPDX-License-Identifier: AGPL-3.0-or-later
//
// POV-Ray's words read as POV-Ray reads them. What stock povray does with each form was tried with
// it; where it is installed, the last test tries it again.
#include "adapter/povray_options.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "adapter/povray_words.h"
#include "core/error.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

/// A folder of scenes, and no povray.ini but ours.
class PovrayOptionsTest : public testing::Test {
   protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "povpreview-options-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
        before_ = fs::current_path();
        fs::current_path(folder_);
        fs::create_directories("sub/deep");
        const char* scene =
            "camera { location 0 look_at z } light_source { 0, 1 }\n"
            "sphere { z * 3, 1 pigment { rgb 1 } }\n";
        for (const char* file :
             {"a.pov", "b.pov", "two words.pov", "plain", "sub/c.pov", "sub/deep/d.pov"})
            write(file, scene);
        write("own.ini", "Width=40\nHeight=30\n");
        setenv("POVINI", (folder_ / "own.ini").c_str(), 1);
        unsetenv("POVINC");
    }
    void TearDown() override {
        unsetenv("POVINI");
        fs::current_path(before_);
        fs::remove_all(folder_);
    }
    static void write(const fs::path& file, const std::string& text) {
        std::ofstream(file) << text;
    }
    static fs::path scene(const std::vector<std::string>& words) {
        return read_povray_options(words).scene;
    }
    /// The message of the usage Error that the words must cause.
    static std::string refusal(const std::vector<std::string>& words) {
        try {
            read_povray_options(words);
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::usage);
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            return error.what();
        }
        ADD_FAILURE() << "no refusal";
        return "";
    }

   private:
    fs::path folder_, before_;
};

TEST_F(PovrayOptionsTest, TheSceneByAllItsNames) {
    for (const char* word : {"a.pov", "+Ia.pov", "+ia.pov", "-Ia.pov", "Input_File_Name=a.pov",
                             "input_file_name=a.pov", "\"a.pov\"", "+I'a.pov'", "+W8 +Ia.pov"})
        EXPECT_EQ(scene({word}), "a.pov") << word;
    EXPECT_EQ(scene({"+Ia"}), "a.pov");
    EXPECT_EQ(scene({"+Iplain"}), "plain");
    EXPECT_EQ(scene({"sub/c.pov"}), "sub/c.pov");
    EXPECT_EQ(scene({"a.pov", "a.pov"}), "a.pov");
    EXPECT_EQ(scene({"A=1", "a.pov", "Declare=x=1", "+Q3", "-A"}), "a.pov");
}

TEST_F(PovrayOptionsTest, LibraryPathsAreSearched) {
    EXPECT_EQ(scene({"c.pov", "+Lsub"}), "sub/c.pov");
    EXPECT_EQ(scene({"+Lsub", "+Lsub/deep", "d.pov"}), "sub/deep/d.pov");
    EXPECT_EQ(scene({"sub/", "c.pov"}), "sub/c.pov");
    EXPECT_EQ(scene({"Library_Path=sub", "c.pov"}), "sub/c.pov");
    setenv("POVINC", "sub", 1);
    EXPECT_EQ(scene({"c.pov"}), "sub/c.pov");
}

TEST_F(PovrayOptionsTest, BlanksInNames) {
    const std::string quoted = "+I\"two words.pov\"";
    for (const char* word : {"two words.pov", "+Itwo words.pov", "Input_File_Name=two words.pov"}) {
        const PovrayOptions options = read_povray_options({word});
        EXPECT_EQ(options.scene, "two words.pov") << word;
        EXPECT_TRUE(options.words[0].ends_with("\"two words.pov\"")) << options.words[0];
    }
    EXPECT_EQ(read_povray_options({quoted}).words[0], quoted);
    // Several words in one argument stay several words.
    EXPECT_EQ(read_povray_options({"a.pov +W20"}).words[0], "a.pov +W20");
}

TEST_F(PovrayOptionsTest, ScenesInIniFiles) {
    write("s.ini",
          "; a comment\nAntialias=on ; +Inot.pov\n+W20 +H10\n[one]\nInput_File_Name = a.pov\n"
          "[two]\n+Ib.pov\n[THREE]\nsub/c.pov\n[four]\nInclude_Ini=deep.ini[x]\n");
    write("sub/deep.ini", "[x]\nInput_File_Name=\"two words.pov\"\n");
    EXPECT_EQ(scene({"s.ini[one]"}), "a.pov");
    EXPECT_EQ(scene({"s.ini[two]"}), "b.pov");
    EXPECT_EQ(scene({"s.ini[three]"}), "sub/c.pov");
    EXPECT_EQ(scene({"+Lsub", "s.ini[four]"}), "two words.pov");
    EXPECT_NE(refusal({"s.ini"}).find("no scene"), std::string::npos);
    // The command line wins, as in POV-Ray.
    EXPECT_EQ(scene({"b.pov", "s.ini[one]"}), "b.pov");
    write("own.ini", "Input_File_Name=b.pov\nLibrary_Path=\"sub\"\n");
    EXPECT_EQ(scene({}), "b.pov");
    EXPECT_EQ(scene({"c.pov"}), "sub/c.pov");
}

TEST_F(PovrayOptionsTest, WhatIsNoSceneIsSaidSo) {
    EXPECT_NE(refusal({}).find("there is no scene"), std::string::npos);
    EXPECT_NE(refusal({"+W10"}).find("povpreview scene.pov"), std::string::npos);
    EXPECT_EQ(refusal({"a.pov", "b.pov"}),
              "there are two scenes, a.pov and b.pov; name one of them");
    EXPECT_EQ(refusal({"no.pov"}),
              "no.pov: there is no such file; check the name, or give the folder it lies in by "
              "+Lfolder");
    EXPECT_NE(refusal({"a.pvo"}).find("a.pvo: there is no such file"), std::string::npos);
    EXPECT_NE(refusal({"+Isub"}).find("this is a folder"), std::string::npos);
    write("loop.ini", "loop.ini\n");
    EXPECT_NE(refusal({"loop.ini"}).find("without end"), std::string::npos);
    if (geteuid() != 0) {
        fs::permissions("a.pov", fs::perms::none);
        EXPECT_NE(refusal({"a.pov"}).find("cannot be read"), std::string::npos);
    }
}

TEST_F(PovrayOptionsTest, SizesThatCannotBeAreRefusedInOneLine) {
    for (const char* word :
         {"+W0", "+W-5", "+W12x", "+W8.5", "+W", "+Wabc", "+W65536", "+W99999999999999999999",
          "+H0", "-H-1", "Width=0", "height=none", "+w0", "+Q3 +W0"})
        EXPECT_NE(refusal({"a.pov", word}).find("in pixels; give a whole number from 1 to 65535"),
                  std::string::npos)
            << word;
    EXPECT_EQ(refusal({"a.pov", "+W65535", "+H65535"}),
              "an image of 65535 x 65535 pixels is too large; choose +W and +H for at most "
              "268435456 pixels");
    for (const char* word : {"+W1", "+W65535", "Width=320", "+WT2", "+WL0", "+HR", "+HIx.inc"})
        EXPECT_EQ(scene({"a.pov", word}), "a.pov") << word;
    EXPECT_EQ(scene({"a.pov", "+W16384", "+H16384"}), "a.pov");
}

TEST_F(PovrayOptionsTest, WhatIsForcedComesLast) {
    const PovrayOptions options = read_povray_options({"a.pov", "+A0.1", "+D", "+Ofoo.png"});
    for (const auto& arguments :
         {options.tracer_arguments(), options.stock_arguments({.output = "out dir/x.png"})}) {
        ASSERT_GT(arguments.size(), 4U);
        EXPECT_TRUE(std::equal(options.words.begin(), options.words.end(), arguments.begin()));
        EXPECT_NE(std::find(arguments.begin(), arguments.end(), "-D"), arguments.end());
    }
    EXPECT_EQ(options.stock_arguments({.output = "out dir/x.png"}).back(), "+O\"out dir/x.png\"");
}

TEST_F(PovrayOptionsTest, StockPovrayMakesOneWholePictureOfTheSizeAsked) {
    if (std::system("command -v povray > /dev/null") != 0) GTEST_SKIP() << "povray is missing";
    // Everything that would make it something else, on the command line and in its INI file.
    write("own.ini",
          "Width=40\nHeight=30\nAntialias=on\nFinal_Frame=3\nStart_Column=7\nOutput_Alpha=on\n");
    fs::create_directory("out dir");
    const PovrayOptions options =
        read_povray_options({"two words.pov", "+H20", "+FT", "+SR0.5", "+KFI2", "-GF"});
    std::string command = "timeout 60 povray";
    for (const std::string& a : options.stock_arguments({.output = "out dir/x.png"}))
        command += " '" + a + "'";
    ASSERT_EQ(std::system((command + " > messages 2>&1").c_str()), 0) << command;
    std::ifstream image("out dir/x.png", std::ios::binary);
    unsigned char head[26] = {};
    image.read(reinterpret_cast<char*>(head), sizeof head);
    ASSERT_TRUE(image) << command;
    EXPECT_EQ(std::string(head + 1, head + 4), "PNG");
    EXPECT_EQ(head[19], 40);  // the low byte of the width, from own.ini
    EXPECT_EQ(head[23], 20);  // of the height
    EXPECT_EQ(head[24], 16);  // bits
    EXPECT_EQ(head[25], 2);   // RGB, no alpha
}

TEST_F(PovrayOptionsTest, WhatAPreviewDoesOtherwiseIsSaid) {
    const auto departures = [](const std::vector<std::string>& words) {
        std::vector<std::string> all{"a.pov"};
        all.insert(all.end(), words.begin(), words.end());
        return read_povray_options(all).departures;
    };
    EXPECT_TRUE(departures({}).empty());
    EXPECT_TRUE(departures({"+A0.1", "+RFI", "-RFO", "-SP8", "-C", "+KFF1", "-GA", "+FN16",
                            "Radiosity_To_File=off", "Final_Frame=1", "+GA"})
                    .empty());
    for (const char* word :
         {"+RFO", "Radiosity_To_File=on", "Pre_Scene_Command=ls", "+SP16", "+EP4",
          "Preview_Start_Size=8", "+C", "Continue_Trace=yes", "+KFF20", "Final_Frame=20",
          "+GAall.txt", "+GImade.ini", "Create_Ini=made.ini", "Statistic_File=s"})
        EXPECT_EQ(departures({word}).size(), 1U) << word;
    write("many.ini", "Post_Frame_Command=rm -r .\n+SP8 +RFO\n[other]\n+C\n");
    EXPECT_EQ(departures({"many.ini"}).size(), 3U);
    EXPECT_EQ(departures({"many.ini[other]"}).size(), 4U);
}

TEST_F(PovrayOptionsTest, TheTracerMayReadWhatLeadsToTheScene) {
    fs::create_directory("lib");
    write("own.ini", "Library_Path=lib\n");
    const std::vector<fs::path> readable = read_povray_options({"a.pov", "own.ini"}).readable;
    const auto has = [&](const fs::path& path) {
        return std::find(readable.begin(), readable.end(), path) != readable.end();
    };
    EXPECT_TRUE(has(fs::current_path()));
    EXPECT_TRUE(has("lib"));
    EXPECT_TRUE(has("own.ini"));
    EXPECT_FALSE(has("/"));
    EXPECT_FALSE(has(""));
}

TEST(PovrayWords, SamplesDependOnThoseThatChangeTheScene) {
    for (const char* word :
         {"+W640", "Height=480", "Declare=X=1", "+Q4", "+K0.5", "+UA", "Output_Alpha=on", "a.pov",
          "+Llib", "+MV3.5", "+RFI", "+RFsaved.rca", "Quality=3", "-MB", "other.ini"})
        EXPECT_TRUE(samples_depend_on(word)) << word;
    for (const char* word : {"+A0.1",
                             "-A",
                             "+AM2",
                             "+AG2.2",
                             "+J",
                             "-J0.5",
                             "+R3",
                             "+Ofile.png",
                             "+FN16",
                             "-F",
                             "+FP",
                             "+D",
                             "+P",
                             "-V",
                             "+WT4",
                             "+SP8",
                             "+GA",
                             "+GSfile",
                             "+TH",
                             "+SC0.5",
                             "Antialias=on",
                             "Antialias_Threshold=0.1",
                             "Sampling_Method=2",
                             "Jitter=off",
                             "Output_File_Name=x",
                             "Output_File_Type=T",
                             "File_Gamma=2",
                             "Work_Threads=3",
                             "Dither=on"})
        EXPECT_FALSE(samples_depend_on(word)) << word;
}

TEST(PovrayWords, AreSplitOutsideQuotes) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(split_words("+W3  +I\"a b.pov\"\t'c d'"), (Words{"+W3", "+I\"a b.pov\"", "'c d'"}));
    EXPECT_EQ(split_words("  "), Words{});
    EXPECT_EQ(split_words("\"open end"), Words{"\"open end"});
    EXPECT_EQ(quoted_name("plain.pov"), "plain.pov");
    EXPECT_EQ(quoted_name("say \"hi\".pov"), "'say \"hi\".pov'");
}

}  // namespace
}  // namespace povpreview
