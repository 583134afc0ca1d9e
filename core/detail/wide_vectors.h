// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

/// Compiled for wider vectors as well, where the machine has them; sanitizers know nothing of the
/// choice made at the start of a program.
#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define POVPREVIEW_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define POVPREVIEW_WIDE_VECTORS
#endif
