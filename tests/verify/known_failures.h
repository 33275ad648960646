// The quick cases that fail with impulse_2007; docs/verification.md says why.
#pragma once

inline constexpr const char* known_failures[] = {"V12", "V13", "V23", "V25", "V31", "V42",
                                                 "V43", "V44", "V57"};
inline constexpr const char* known_in_single[] = {"V02", "V09"};
