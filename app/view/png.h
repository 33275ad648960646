// PNG files with text inside, so that a picture tells where it comes from.
#pragma once

#include <string>
#include <utility>

#include "view/image.h"

namespace sudar::view {

// Keys and values, in order: "Software", "scenario", "time", …
using PngText = std::vector<std::pair<std::string, std::string>>;

// Throw std::runtime_error naming the file. A file that could not be written whole is removed.
void write_png(const std::string& path, const Image&, const PngText& = {});
Image read_png(const std::string& path, PngText* text = nullptr);

}
