#include "main/movie.h"

#include <sudar/base.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

extern char** environ;

namespace sudar::app {

using namespace view;

namespace {

namespace fs = std::filesystem;

bool is_webm(const std::string& path) { return fs::path(path).extension() == ".webm"; }

std::vector<std::string> codec(const std::string& path) {
  if (is_webm(path))
    return {"-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0", "-row-mt", "1", "-pix_fmt", "yuv420p", "-f", "webm"};
  return {"-c:v",     "libx264", "-crf",      "18",         "-preset", "medium",
          "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",      "mp4"};
}

std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = folder + "/" + name;
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return "";
}

class Encoded : public Movie {
 public:
  Encoded(const std::string& ffmpeg, const std::string& path, int width, int height, int fps, const PngText& provenance)
      : path_(path), partial_(path + ".part") {
    std::string comment;
    for (const auto& [key, value] : provenance) comment += (comment.empty() ? "" : "; ") + key + ": " + value;
    std::vector<std::string> arguments{ffmpeg,      "-loglevel",
                                       "error",     "-y",
                                       "-f",        "rawvideo",
                                       "-pix_fmt",  "rgba",
                                       "-s",        std::to_string(width) + "x" + std::to_string(height),
                                       "-r",        std::to_string(fps),
                                       "-i",        "-",
                                       "-metadata", "comment=" + comment};
    for (const std::string& word : codec(path)) arguments.push_back(word);
    arguments.push_back(partial_);
    start(arguments);
  }
  ~Encoded() override {
    if (pipe_ >= 0) stop(), std::remove(partial_.c_str());
  }
  void add(const Image& image) override {
    const std::uint8_t* data = image.rgba.data();
    std::size_t left = image.rgba.size();
    while (left > 0) {
      const ssize_t written = write(pipe_, data, left);
      if (written <= 0) fail();
      data += written;
      left -= std::size_t(written);
    }
  }
  std::string finish() override {
    if (stop() != 0 || std::rename(partial_.c_str(), path_.c_str()) != 0) fail();
    return path_;
  }

 private:
  void start(const std::vector<std::string>& arguments) {
    std::signal(SIGPIPE, SIG_IGN);  // a dead ffmpeg shows as a failed write
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Error(path_, "no pipe to ffmpeg");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    std::vector<char*> words;
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const int error = posix_spawn(&process_, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    pipe_ = ends[1];
    if (error != 0) close(pipe_), throw Error(path_, "ffmpeg does not start");
  }
  int stop() {
    close(pipe_);
    pipe_ = -1;
    int status = 0;
    waitpid(process_, &status, 0);
    return status;
  }
  [[noreturn]] void fail() {
    if (pipe_ >= 0) stop();
    std::remove(partial_.c_str());
    throw Error(path_, "ffmpeg could not write it");
  }

  std::string path_, partial_;
  pid_t process_ = 0;
  int pipe_ = -1;
};

class Sequence : public Movie {
 public:
  Sequence(const std::string& path, int fps, const PngText& provenance)
      : path_(path), folder_(path + ".frames"), fps_(fps), provenance_(provenance) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw Error(folder_, "cannot be made (" + error.message() + ")");
  }
  void add(const Image& image) override {
    char name[24];
    std::snprintf(name, sizeof name, "/%05d.png", ++frames_);
    write_png(folder_ + name, image, provenance_);
  }
  std::string finish() override {
    std::string line = "ffmpeg -framerate " + std::to_string(fps_) + " -i '" + folder_ + "/%05d.png'";
    for (const std::string& word : codec(path_)) line += " " + word;
    return std::to_string(frames_) + " pictures in " + folder_ +
           "; there is no ffmpeg here. Where there is one, this joins them:\n" + line + " '" + path_ + "'";
  }

 private:
  std::string path_, folder_;
  int fps_, frames_ = 0;
  PngText provenance_;
};

}

std::unique_ptr<Movie> make_movie(const std::string& path, int width, int height, int frames_per_second,
                                  const PngText& provenance) {
  if (width % 2 != 0 || height % 2 != 0) throw Error("--size", "a movie needs an even width and height");
  const std::string ffmpeg = find_program("ffmpeg");
  if (ffmpeg.empty()) return std::make_unique<Sequence>(path, frames_per_second, provenance);
  return std::make_unique<Encoded>(ffmpeg, path, width, height, frames_per_second, provenance);
}

}
