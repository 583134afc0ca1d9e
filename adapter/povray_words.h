// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// POV-Ray's way of reading words, from a command line or an INI file (its ProcessOptions).
namespace povpreview {

/// One setting. Only those that we must understand are told apart.
struct PovrayWord {
    enum class Kind {
        input,          ///< +Ifile, Input_File_Name=file, file.pov
        library,        ///< +Lfolder, Library_Path=folder, folder/
        ini,            ///< file.ini[section], Include_Ini=file
        width,          ///< +Wn, Width=n
        height,         ///< +Hn, Height=n
        antialias,      ///< +A, -A, Antialias=bool; the switches' value is "on" or "off"
        threads,        ///< +WTn, Work_Threads=n
        initial_frame,  ///< +KFIn, Initial_Frame=n
        final_frame,    ///< +KFFn, Final_Frame=n
        frame_step,     ///< +STPn, Frame_Step=n
        subset_start,   ///< +SFn, Subset_Start_Frame=n, or a share below 1
        subset_end,     ///< +EFn, Subset_End_Frame=n, or a share below 1
        cyclic,         ///< +KC, -KC, Cyclic_Animation=bool; as antialias
        other
    };
    Kind kind = Kind::other;
    std::string value;  ///< behind the keyword, without quotes
};

/// What an option that does not mean the same in a preview is about.
enum class Departure {
    none,
    saves_radiosity,  ///< +RFO, Radiosity_To_File=on
    runs_command,     ///< Pre_Scene_Command and the like
    mosaic,           ///< +SP, +EP: POV-Ray's own preview
    continues,        ///< +C: goes on from POV-Ray's own state file
    animation,        ///< +KFF: more than one frame
    writes_messages,  ///< +GAfile and the like
};
/// That of one word, if it is turned on.
Departure departure_of(std::string_view word);

/// Whether what a sample finds may depend on this word: not on those that say how samples are put
/// together, shown, and saved.
bool samples_depend_on(std::string_view word);

/// Splits at blanks outside quotes, as POV-Ray does even with a single argument of the shell.
std::vector<std::string> split_words(std::string_view text);

/// Reads one word that split_words() made.
PovrayWord read_word(std::string_view word);

/// Whether a value means yes to POV-Ray.
bool is_on(std::string_view value);

/// An argument of the shell as POV-Ray must get it: file names with blanks, which it would split,
/// are quoted, if a file of that name exists.
std::string quoted_for_povray(const std::string& argument);

/// A file name as POV-Ray reads it back as one.
std::string quoted_name(const std::string& name);

}  // namespace povpreview
