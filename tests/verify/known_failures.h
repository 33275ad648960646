// The cases that fail with impulse_2007 in this precision; docs/verification.md says why.
#pragma once

inline constexpr const char* known_failures[] = {"V09"};
