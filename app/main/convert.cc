// sudar lint and sudar convert: files of other programs, looked through and turned into each other.
#include <cstdio>
#include <map>

#include "main/command.h"
#include "main/files.h"

namespace sudar::app {

namespace {

// Prints what was found; whether the file was refused.
bool tell(const io::Reading& reading) {
  for (const io::Finding& f : reading.findings) std::printf("%s\n", io::text(f).c_str());
  return !reading.made;
}

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

int lint(const std::vector<std::string>& files, const io::ReadOptions& options) {
  bool refused = false;
  for (const std::string& file : files) {
    const io::Reading reading = io::read(file, options);
    if (tell(reading)) {
      refused = true;
      continue;
    }
    const io::Model& m = *reading.made;
    std::printf("%s: %s, %s, %s\n", file.c_str(), count(m.bodies.size(), "body", "bodies").c_str(),
                count(m.joints.size(), "joint", "joints").c_str(),
                count(reading.findings.size(), "finding", "findings").c_str());
  }
  return refused ? 1 : 0;
}

int convert(const std::string& from, const std::string& to, const io::ReadOptions& options) {
  if (!io::is_writable(to)) throw Error(to, "the name does not end with one of " + io::list(io::writable_endings()));
  expect_writable(to);
  const io::Reading reading = io::read(from, options);
  for (const io::Finding& f : reading.findings) std::fprintf(stderr, "sudar: %s\n", io::text(f).c_str());
  std::vector<io::Finding> lost;
  write_file(to, io::write(reading.model(), to, lost));
  for (const io::Finding& f : lost) std::fprintf(stderr, "sudar: %s\n", io::text(f).c_str());
  std::printf("%s\n", to.c_str());
  return 0;
}

}

void add_reading(CLI::App& app, io::ReadOptions& options) {
  app.add_option_function<std::vector<std::string>>(
         "--allow",
         [&options](const std::vector<std::string>& folders) { options.allow.assign(folders.begin(), folders.end()); },
         "a folder that an opened file may read from, besides its own; may be repeated")
      ->allow_extra_args(false);
  app.add_option("--unit", options.unit,
                 "length of an opened file's unit, where its format does not say it: m, cm, mm, in, ft")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, double>{{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}));
}

void add_lint(CLI::App& app, Action& chosen, io::ReadOptions& options) {
  CLI::App* sub =
      app.add_subcommand("lint", "what is found when files of other programs are read; exit 1 if one is refused");
  const auto files = std::make_shared<std::vector<std::string>>();
  sub->add_option("files", *files, io::list(io::readable_endings()))->required();
  add_reading(*sub, options);
  sub->callback(
      [&chosen, &options, files] { chosen = [&options, files](const Catalogue&) { return lint(*files, options); }; });
}

void add_convert(CLI::App& app, Action& chosen, io::ReadOptions& options) {
  CLI::App* sub = app.add_subcommand("convert", "turn a file of another program into one of another format");
  const auto names = std::make_shared<std::pair<std::string, std::string>>();
  sub->add_option("in", names->first, io::list(io::readable_endings()))->required();
  sub->add_option("out", names->second, io::list(io::writable_endings()))->required();
  add_reading(*sub, options);
  sub->callback([&chosen, &options, names] {
    chosen = [&options, names](const Catalogue&) { return convert(names->first, names->second, options); };
  });
}

}
