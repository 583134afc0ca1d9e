// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/image_library.h"
#include "display/openimageio/caption.h"
#include "display/openimageio/image_file.h"

/// The one name that image_library() looks for.
extern "C" const povpreview::ImageLibrary* povpreview_image_library() {
    using namespace povpreview;
    static constexpr ImageLibrary library{openimageio::encoded_image, openimageio::read_image,
                                          openimageio::caption_strip, openimageio::annotated_image};
    return &library;
}
