// The report: a folder of HTML pages that open without a server and without scripts. A page for each case with its law,
// numbers, curves and, where theory gives an order, the deviation against the step size; and an index that sets Sudar
// beside the engines that were measured with the same scenes.
#pragma once

#include "verify/runner.h"

namespace sudar::verify {

// Makes the folder. Throws Error when it cannot be written.
void write_report(const std::string& folder, const std::vector<Result>&);

}
