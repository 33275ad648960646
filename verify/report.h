// The results as pages for a browser: an index with the table beside other engines, and a page for each case with its
// law, a picture, the curves of theory and simulation, and the errors against the step size.
#pragma once

#include <filesystem>

#include "verify/runner.h"

namespace sudar::verify {

// Into the folder, which is made; `engine` is what the pages say was measured. Throws Error when it cannot write.
void write_report(const std::vector<Result>&, const std::filesystem::path& folder, const std::string& engine);

}
