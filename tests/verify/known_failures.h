// The quick cases that fail with impulse_2007; docs/verification.md says why.
#pragma once

inline constexpr const char* known_failures[] = {"V02", "V09", "V12", "V13", "V23", "V43", "V53"};
