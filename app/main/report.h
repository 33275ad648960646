// The one JSON schema of `sudar run` and `sudar bench` (docs/json.md).
#pragma once

#include <sudar/session.h>

#include <nlohmann/json.hpp>

#include "bench/meter.h"

namespace sudar::app {

using Json = nlohmann::ordered_json;

Json report(const Session&, const bench::Meter&);

// `check` has no verdict that is bad.
bool nothing_failed(const Check&);

// A hash as everywhere in the program: 16 hexadecimal digits.
std::string hex(std::uint64_t);

// The parameters in words: "ball=0 rows=10".
std::string parameters_text(const Session&);

}
