// Pictures one after the other into a movie: through ffmpeg where there is one, else as a sequence of PNG files, with
// the line that joins them.
#pragma once

#include <memory>
#include <string>

#include "view/png.h"

namespace sudar::app {

class Movie {
 public:
  virtual ~Movie() = default;  // of a movie that was not finished nothing remains but PNG files
  virtual void add(const view::Image&) = 0;
  virtual std::string finish() = 0;  // returns what there is now, in words
};

// `path` ends with .mp4 or .webm. Throws Error naming what is wrong.
std::unique_ptr<Movie> make_movie(const std::string& path, int width, int height, int frames_per_second,
                                  const view::PngText& provenance);

}
