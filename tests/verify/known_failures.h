// The cases that fail with impulse_2007; docs/verification.md says why.
#pragma once

inline constexpr const char* known_failures[] = {"V06", "V07", "V08", "V09", "V26", "V27", "V51", "V61"};
