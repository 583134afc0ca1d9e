// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What the sanitizers are to leave out: libraries that were built without them. LeakSanitizer sees
// the state that Mesa and OpenImageIO keep until the end; ThreadSanitizer does not see the locks of
// their own threads, and takes every hand-over between them for a race.

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions();

const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\n"
           "leak:libOpenImageIO\n"
           "leak:swrast_dri\n"
           "leak:libEGL\n"
           "leak:libGLX\n"
           "leak:libLLVM\n";
}

const char* __tsan_default_suppressions() {
    return "race:libOSMesa\n"
           "race:libOpenImageIO\n"
           "race:swrast_dri\n"
           "race:libEGL\n"
           "race:libGLX\n"
           "race:libLLVM\n"
           "mutex:libOSMesa\n"
           "mutex:swrast_dri\n"
           "thread:swrast_dri\n"
           "thread:libOpenImageIO\n";
}
