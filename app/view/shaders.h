// The texts of the files in view/shaders, put into the program by CMake.
#pragma once

#include <string>

namespace sudar::view {

std::string shader_text(const std::string& file);  // throws std::runtime_error: no such file

}
