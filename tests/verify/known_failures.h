// The quick cases that fail with impulse_2007; docs/verification.md says why.
#pragma once

inline constexpr const char* known_failures[] = {"V02", "V06", "V07", "V08", "V09", "V12", "V13", "V23",
                                                 "V26", "V27", "V43", "V51", "V53", "V57", "V59", "V61"};
