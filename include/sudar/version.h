// The version of the engine: https://semver.org. The build reads it from here.
#pragma once

#define SUDAR_VERSION "0.1.0"
