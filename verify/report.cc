#include "verify/report.h"

namespace sudar::verify {

void write_report(const std::string&, const std::vector<Result>&) {}

}
