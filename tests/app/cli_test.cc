// The program from outside: what it prints, what it writes, how it ends. Runs the binary.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "view/png.h"

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Cli : testing::Test {
  struct Result {
    int code;
    std::string out, err;
  };

  fs::path folder = fs::path(testing::TempDir()) / ("sudar_cli_" + std::to_string(getpid()));
  Cli() { fs::create_directories(folder); }
  ~Cli() override { fs::remove_all(folder); }
  std::string file(const char* name) const { return (folder / name).string(); }

  Result sudar(const std::string& arguments, const std::string& environment = "") const {
    const std::string out = file("stdout"), err = file("stderr");
    const std::string line = "cd '" + folder.string() + "' && " + environment + " '" SUDAR_PROGRAM "' " + arguments +
                             " >'" + out + "' 2>'" + err + "' </dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
  }
};

// The paths of all fields: "awake.min"; elements of arrays count as their array.
void collect(const Json& j, const std::string& path, std::set<std::string>& fields) {
  if (!path.empty()) fields.insert(path);
  if (j.is_object()) {
    for (const auto& [name, value] : j.items()) collect(value, path.empty() ? name : path + "." + name, fields);
  }
  if (j.is_array()) {
    for (const Json& element : j) collect(element, path, fields);
  }
}

// The table of docs/json.md: field → when.
std::map<std::string, std::string> documented() {
  std::map<std::string, std::string> fields;
  std::ifstream in(SUDAR_SOURCE "/docs/json.md");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    std::vector<std::string> cells;
    std::istringstream parts(line.substr(1));
    for (std::string cell; std::getline(parts, cell, '|');) {
      cell.erase(0, cell.find_first_not_of(" `"));
      cell.erase(cell.find_last_not_of(" `") + 1);
      cells.push_back(cell);
    }
    fields[cells.at(0)] = cells.at(2);
  }
  return fields;
}

bool matches(const std::string& pattern, const std::string& path) {
  std::istringstream a(pattern), b(path);
  std::string x, y;
  while (true) {
    const bool more_a = bool(std::getline(a, x, '.')), more_b = bool(std::getline(b, y, '.'));
    if (more_a != more_b) return false;
    if (!more_a) return true;
    if (x != "*" && x != y) return false;
  }
}

void expect_as_documented(const Json& output, bool bench) {
  std::set<std::string> fields;
  collect(output, "", fields);
  const auto table = documented();
  ASSERT_GT(table.size(), 40u);
  for (const std::string& field : fields) {
    const bool known =
        std::any_of(table.begin(), table.end(), [&](const auto& row) { return matches(row.first, field); });
    EXPECT_TRUE(known) << field << " is not documented in docs/json.md";
  }
  for (const auto& row : table) {
    const std::string &pattern = row.first, &when = row.second;
    if (when == "some" || (when == "bench" && !bench)) continue;
    const bool there = std::any_of(fields.begin(), fields.end(), [&](const auto& f) { return matches(pattern, f); });
    EXPECT_TRUE(there) << pattern << " is documented but not printed";
  }
}

TEST_F(Cli, Version) {
  const Result r = sudar("--version");
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.out.rfind("sudar ", 0), 0u) << r.out;
}

TEST_F(Cli, ListNamesTheScenes) {
  const Result r = sudar("list");
  EXPECT_EQ(r.code, 0);
  for (const char* name : {"wall", "towers", "dominoes", "spinning_ball", "net"}) {
    EXPECT_NE(r.out.find(std::string("\n") + name + " "), std::string::npos) << name;
  }
  const Json all = Json::parse(sudar("list --json").out);
  for (const Json& scene : all) {
    EXPECT_FALSE(scene["about"].get<std::string>().empty()) << scene["name"];
    EXPECT_TRUE(scene["parameters"].is_array());
  }
}

TEST_F(Cli, RunJsonIsAsDocumented) {
  const Result r = sudar("run bouncing_boxes --seconds 2 --json");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.err, "") << "no progress bar in a pipe";
  const Json j = Json::parse(r.out);
  expect_as_documented(j, false);
  EXPECT_EQ(j["scenario"], "bouncing_boxes");
  EXPECT_EQ(j["steps"], 200);
  EXPECT_NEAR(j["seconds"].get<double>(), 2, 1e-9);
  EXPECT_EQ(j["hash"].get<std::string>().size(), 16u);
}

// The state covers the settings; the motion is the same with every broad phase.
TEST_F(Cli, BroadPhasesMoveAlike) {
  const auto run = [&](const char* broad) {
    return Json::parse(sudar(std::string("run bouncing_boxes --steps 150 --json --broad ") + broad).out);
  };
  const Json tree = run("tree"), grid = run("grid");
  EXPECT_EQ(tree["motion_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(tree["motion_hash"], grid["motion_hash"]);
  EXPECT_NE(tree["hash"], grid["hash"]);
}

// Two recordings or saved runs: the same, different from the beginning on, different by what the user did.
TEST_F(Cli, DiffNamesTheFirstDifference) {
  const auto record = [&](const char* name, const std::string& options) {
    EXPECT_EQ(sudar("run vehicle --steps 60 " + options + " --record " + name + " --save " + name + ".run@60").code, 0);
  };
  record("plain", ""), record("again", ""), record("grid", "--broad grid"), record("gas", "--keys 0.2:up");
  const Result same = sudar("diff plain again --json");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_EQ(Json::parse(same.out)["same"], true);
  EXPECT_EQ(Json::parse(same.out)["steps"], 60);
  EXPECT_EQ(sudar("diff plain.run again.run").code, 0);

  const Result grid = sudar("diff plain grid --json");
  EXPECT_EQ(grid.code, 1);
  const Json setting = Json::parse(grid.out);
  EXPECT_EQ(setting["same"], false);
  EXPECT_EQ(setting["step"], 0);
  EXPECT_EQ(setting["stage"], "start");
  EXPECT_TRUE(setting["body"].is_null());
  EXPECT_EQ(setting["field"], "config.broad");
  EXPECT_EQ(setting["a"], "tree");
  EXPECT_EQ(setting["b"], "grid");
  EXPECT_EQ(Json::parse(sudar("diff plain.run grid.run --json").out)["field"], "config.broad");

  const Result gas = sudar("diff plain gas --json");
  EXPECT_EQ(gas.code, 1);
  const Json operation = Json::parse(gas.out);
  EXPECT_GT(operation["step"], 10);
  EXPECT_EQ(operation["stage"], "operation");
  EXPECT_NE(operation["a"], operation["b"]);
  const std::string words = sudar("diff plain gas").out;
  EXPECT_NE(words.find("step " + operation["step"].dump()), std::string::npos) << words;
  EXPECT_NE(words.find(operation["field"].get<std::string>()), std::string::npos) << words;

  for (const char* files : {"plain plain.run", "plain stdout", "plain nothing_here"}) {
    const Result bad = sudar(std::string("diff ") + files);
    EXPECT_EQ(bad.code, 2) << files;
    EXPECT_NE(bad.err.find(std::string(files).substr(6)), std::string::npos) << bad.err;
  }
}

TEST_F(Cli, BenchJsonIsAsDocumented) {
  const Result r = sudar("bench --thesis sticks --json");
  ASSERT_EQ(r.code, 0) << r.err;
  const Json all = Json::parse(r.out);
  ASSERT_EQ(all.size(), 1u);
  expect_as_documented(all[0], true);
  EXPECT_EQ(all[0]["config"]["sleep"], false);
  EXPECT_EQ(all[0]["steps"], 1100);
}

TEST_F(Cli, AFailedCheckIsExitCodeOne) {
  const Result r = sudar("run wall --set ball=0 --set gravity=0 --seconds 0.5 --json --config impulse_2007.slop=0");
  EXPECT_EQ(r.code, 0) << "nothing moves: " << r.out;
  const Result bad = sudar("run bouncing_boxes --config impulse_2007.collision_passes=0 --json");
  EXPECT_EQ(bad.code, 1);
  EXPECT_EQ(Json::parse(bad.out)["passed"], false);
}

TEST_F(Cli, ChecksThatWereNotReachedHaveNoVerdict) {
  const Result r = sudar("run spinning_ball --steps 3 --json");
  EXPECT_EQ(r.code, 0);
  for (const Json& check : Json::parse(r.out)["checks"]) EXPECT_TRUE(check["pass"].is_null()) << check;
}

TEST_F(Cli, OptionsReachTheEngine) {
  const Json j = Json::parse(
      sudar(
          "run wall --steps 2 --dt 0.02 --substeps 3 --time-factor 0.5 --no-sleep --broad brute --solver impulse_2007 "
          "--set ball=0 --set rows=2 --config impulse_2007.contact_passes=7 --json")
          .out);
  EXPECT_EQ(j["config"]["dt"], 0.02);
  EXPECT_EQ(j["config"]["substeps"], 3);
  EXPECT_EQ(j["config"]["time_factor"], 0.5);
  EXPECT_EQ(j["config"]["sleep"], false);
  EXPECT_EQ(j["config"]["impulse_2007"]["contact_passes"], 7);
  EXPECT_EQ(j["parameters"]["ball"], false);
  EXPECT_EQ(j["parameters"]["rows"], 2);
  EXPECT_EQ(j["bodies"], 11);
  EXPECT_NEAR(j["seconds"].get<double>(), 0.02, 1e-9);
}

// Bad input: exit code 2, and the message names what was given and what was expected.
TEST_F(Cli, BadInputIsNamed) {
  const std::pair<const char*, std::vector<const char*>> cases[] = {
      {"run wal", {"wal", "did you mean", "wall"}},
      {"wal", {"wal", "did you mean", "wall"}},
      {"run", {"scene"}},
      {"run wall --set bricks=3", {"bricks", "rows"}},
      {"run wall --set rows", {"--set", "rows", "NAME=VALUE"}},
      {"run wall --set rows=many", {"rows", "many", "number"}},
      {"run wall --set rows=1000", {"rows", "1000", "30"}},
      {"run wall --config passes=3", {"passes"}},
      {"run wall --dt=-1", {"dt", "-1"}},
      {"run wall --solver magic", {"solver", "magic", "impulse_2007"}},
      {"run wall --seconds soon", {"--seconds", "soon"}},
      {"run wall --keys 5", {"keys", "5"}},
      {"run wall --save out", {"--save", "out", "FILE@STEP"}},
      {"run wall --steps 3 --save out@9", {"--save", "9", "3"}},
      {"run wall --load nothing_here", {"nothing_here"}},
      {"run wall --csv /no/such/folder/a.csv", {"/no/such/folder/a.csv"}},
      {"replay nothing_here", {"nothing_here"}},
      {"render wall -o picture.gif", {"picture.gif", ".png"}},
      {"render wall -o a.png --size 12", {"--size", "12"}},
      {"render wall -o a.png --camera 1,2", {"--camera", "1,2"}},
      {"render wall", {"--output"}},
      {"bench --thesis cradle", {"cradle"}},
      {"--scenarios /no/such/folder list", {"/no/such/folder"}},
  };
  for (const auto& [arguments, words] : cases) {
    const Result r = sudar(arguments);
    EXPECT_EQ(r.code, 2) << arguments;
    EXPECT_EQ(r.out, "") << arguments;
    for (const char* word : words) EXPECT_NE(r.err.find(word), std::string::npos) << arguments << "\n" << r.err;
  }
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    EXPECT_TRUE(name == "stdout" || name == "stderr") << name << " was left behind";
  }
}

TEST_F(Cli, BenchMeasuresPictures) {
  const Result r = sudar("bench --picture --bodies 12 --json");
  ASSERT_EQ(r.code, 0) << r.err;
  const Json j = Json::parse(r.out);
  EXPECT_EQ(j["bodies"], 12);
  for (const char* finish : {"plain", "fine"}) {
    EXPECT_GT(j[finish]["ms"].get<double>(), 0);
    EXPECT_GT(j[finish]["cpu_ms"].get<double>(), 0);
  }
  EXPECT_GT(j["step_us"]["alone"].get<double>(), 0);
  EXPECT_GT(j["step_us"]["beside"].get<double>(), 0);
}

TEST_F(Cli, APluginThatIsNoneIsRefusedByNameAndTheOthersStay) {
  const fs::path plugins = folder / "plugins",
                 usual = fs::path(SUDAR_PROGRAM).parent_path() / SUDAR_SCENARIOS_FROM_PROGRAM;
  if (!fs::exists(usual)) GTEST_SKIP() << "the scenarios are linked in";
  fs::create_directories(plugins);
  fs::copy_file(usual / "train.so", plugins / "train.so");
  fs::copy_file(usual / "train.so", plugins / "train_again.so");
  std::ofstream(plugins / "broken.so") << "no library";
  const Result r = sudar("list", "SUDAR_SCENARIOS='" + plugins.string() + "'");
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.out.rfind("train ", 0), 0u) << r.out;
  EXPECT_NE(r.err.find("broken.so refused"), std::string::npos) << r.err;
  EXPECT_NE(r.err.find("train_again.so refused"), std::string::npos) << r.err;
}

TEST_F(Cli, SavedAndLoadedGoesOnWithTheSameBits) {
  ASSERT_EQ(sudar("run dominoes --seconds 1.5 --save half@100").code, 0);
  const Json whole = Json::parse(sudar("run dominoes --steps 150 --json").out);
  const Json half = Json::parse(sudar("run dominoes --load half --steps 150 --json").out);
  EXPECT_EQ(whole["hash"], half["hash"]);
  EXPECT_EQ(half["steps"], 150);
  const Result other = sudar("run wall --load half");
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("dominoes"), std::string::npos) << other.err;
}

TEST_F(Cli, ARecordingReplaysAndADamagedOneDoesNot) {
  ASSERT_EQ(sudar("run cradle --seconds 1 --record tape").code, 0);
  const Result good = sudar("replay tape --check");
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  EXPECT_NE(good.out.find("cradle"), std::string::npos);
  const Result shared = sudar("replay tape --check --workers 3");
  EXPECT_EQ(shared.out, good.out) << shared.err;
  const Result none = sudar("replay tape --workers 0");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("workers"), std::string::npos) << none.err;
  fs::resize_file(folder / "tape", fs::file_size(folder / "tape") / 2);
  EXPECT_EQ(sudar("replay tape --check").code, 2);
}

// A file of another program is run, saved, gone on with, drawn, looked through and turned into another, as scenarios are.
TEST_F(Cli, AFileIsAScenario) {
  std::ofstream(file("my box.obj")) << "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const Result run = sudar("run 'my box.obj' --unit cm --steps 20 --save s@10 --json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(Json::parse(sudar("run 'my box.obj' --unit cm --load s --steps 20 --json").out)["hash"],
            Json::parse(run.out)["hash"]);
  EXPECT_EQ(sudar("render 'my box.obj' --at 0.1 --size 64x64 -o a.png").code, 0);
  EXPECT_TRUE(fs::exists(folder / "a.png"));

  const Result converted = sudar("convert --unit mm 'my box.obj' a.glb");
  EXPECT_EQ(converted.code, 0) << converted.err;
  const Result good = sudar("lint a.glb 'my box.obj'");
  EXPECT_EQ(good.code, 0) << good.out;
  EXPECT_NE(good.out.find("a.glb: 2 bodies, 0 joints"), std::string::npos) << good.out;

  std::ofstream(file("bad.obj")) << "v 0 0 0\nf 1 2 3\n";
  const Result bad = sudar("lint bad.obj a.glb");
  EXPECT_EQ(bad.code, 1);
  EXPECT_NE(bad.out.find("bad.obj:2: error: names vertex 2"), std::string::npos) << bad.out;
  EXPECT_EQ(sudar("run bad.obj").code, 2);
  EXPECT_NE(sudar("run bad.obj").err.find("bad.obj:2: names vertex 2"), std::string::npos);
  EXPECT_EQ(sudar("convert a.glb a.step").code, 2);
  EXPECT_EQ(sudar("run none.glb").code, 2);
}

TEST_F(Cli, CsvHasUnitsAndARowForEveryStep) {
  ASSERT_EQ(sudar("run wall --steps 5 --set rows=1 --csv course.csv").code, 0);
  std::istringstream in(text_of(folder / "course.csv"));
  std::string header, line;
  std::getline(in, header);
  EXPECT_EQ(header.rfind("time [s],kinetic [J],potential [J],total [J],", 0), 0u) << header;
  EXPECT_NE(header.find("\"ball.z [m]\""), std::string::npos) << header;
  EXPECT_EQ(header.find("floor"), std::string::npos) << "fixed bodies have no columns";
  int rows = 0;
  const auto commas = [](const std::string& s) { return std::count(s.begin(), s.end(), ','); };
  for (; std::getline(in, line); ++rows) EXPECT_EQ(commas(line), commas(header));
  EXPECT_EQ(rows, 6) << "the start and five steps";
}

TEST_F(Cli, APictureTellsWhereItComesFrom) {
  const Result r = sudar("render spinning_ball -o ball.png --at 0.5 --size 320x180 --contacts");
  ASSERT_EQ(r.code, 0) << r.err;
  sudar::view::PngText text;
  const sudar::view::Image image = sudar::view::read_png(file("ball.png"), &text);
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 180);
  const std::map<std::string, std::string> notes(text.begin(), text.end());
  EXPECT_EQ(notes.at("scenario"), "spinning_ball");
  EXPECT_EQ(notes.at("step"), "50");
  EXPECT_EQ(notes.at("time"), "0.5 s");
  EXPECT_EQ(notes.at("state").size(), 16u);
}

TEST_F(Cli, ARecordingCanBeDrawn) {
  ASSERT_EQ(sudar("run spinning_ball --seconds 0.3 --record tape").code, 0);
  EXPECT_EQ(sudar("render tape -o tape.png --at 0.2 --size 160x90").code, 0);
  EXPECT_TRUE(fs::exists(folder / "tape.png"));
  EXPECT_EQ(sudar("render tape -o late.png --at 5 --size 160x90").code, 2);
}

TEST_F(Cli, WithoutFfmpegAMovieIsASequenceAndALine) {
  const Result r = sudar("render spinning_ball -o ball.mp4 --seconds 0.2 --fps 20 --size 160x90", "PATH=/nowhere");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.out.find("ffmpeg -framerate 20"), std::string::npos) << r.out;
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator(folder / "ball.mp4.frames"))
    pictures += entry.path().extension() == ".png";
  EXPECT_EQ(pictures, 5);
}

TEST_F(Cli, WithFfmpegAMovieIsAFile) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  const Result r = sudar("render spinning_ball -o ball.mp4 --seconds 0.2 --fps 20 --size 160x90");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_GT(fs::file_size(folder / "ball.mp4"), 500u);
  EXPECT_FALSE(fs::exists(folder / "ball.mp4.part"));
}

TEST_F(Cli, WithoutASubCommandOneSceneIsDrawn) {
  const Result r = sudar("cradle");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.out.find("out/cradle.png"), std::string::npos) << r.out;
  EXPECT_TRUE(fs::exists(folder / "out/cradle.png"));
}

}
