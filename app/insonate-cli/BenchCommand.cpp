#include "Commands.h"
#include "curriculum/CurriculumBench.h"

#include <insonate/bench/DeformationBench.h>
#include <insonate/bench/DopplerBench.h>
#include <insonate/bench/HandsBench.h>
#include <insonate/bench/HapticsBench.h>
#include <insonate/bench/PointSpreadBench.h>
#include <insonate/bench/RealismBench.h>
#include <insonate/bench/SegmentationBench.h>
#include <insonate/bench/ServerBench.h>
#include <insonate/bench/UltrasoundBench.h>
#include <insonate/bench/WireBench.h>
#include <insonate/cases/Phantom.h>
#include <insonate/ultrasound/SetupText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

struct BenchOptions {
  std::string folder;
  bool quick = false, json = false;
};

template <class Results>
void tell(const BenchOptions& options, const Results& results, const char* page) {
  if (options.json)
    printJson(toJson(results));
  else
    std::cout << (std::filesystem::path(options.folder) / page).string() << '\n';
}

Result<void> benchUltrasound(const BenchOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  const auto plan = ultrasoundBenchPlan(options.quick, terminalProgress());
  if (!plan) return tl::unexpected(plan.error());
  const auto results = runUltrasoundBench(*plan, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeUltrasoundBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "index.md");
  return {};
}

Result<void> benchDeformation(const BenchOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  const auto results = runDeformationBench(options.quick, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeDeformationBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "deformation.md");
  return {};
}

Result<void> benchDoppler(const BenchOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  const auto results = runDopplerBench(options.quick, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeDopplerBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "doppler.md");
  return {};
}

Result<void> benchHaptics(const BenchOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  const auto results = runHapticsBench(options.quick, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeHapticsBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "haptics.md");
  return {};
}

Result<void> benchWire(const BenchOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  const auto results = runWireBench(options.quick, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeWireBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "wire.md");
  return {};
}

Result<void> benchHands(const BenchOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  const auto results = runHandsBench(options.quick, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeHandsBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "hands.md");
  return {};
}

struct SegmentationOptions : BenchOptions {
  SegmentationBenchPlan plan;
  std::string only;
};

Result<void> benchSegmentation(SegmentationOptions options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  SegmentationBenchPlan& plan = options.plan;
  plan.quick = options.quick;
  if (plan.necks.empty() && (options.only.empty() || options.only == "necks"))
    for (const PhantomVariant& neck : phantomVariants().first(plan.quick ? 1 : phantomVariants().size()))
      // Automatic labels and their guide are made for necks.
      if (neck.region == PhantomRegion::kNeck || neck.name == "subclavian") plan.necks.emplace_back(neck.name);
  plan.automatic = options.only.empty() || options.only == "automatic";
  plan.speed = options.only == "speed" || (options.only.empty() && !options.quick);
  const auto results = runSegmentationBench(plan, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeSegmentationBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "segmentation.md");
  return {};
}

Result<void> benchCurriculum(const BenchOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  const auto results = runCurriculumBench(options.quick, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeCurriculumBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "curriculum.md");
  return {};
}

struct ServerOptions : BenchOptions {
  ServerLoad load;
  double minutes = 60;
};

Result<void> benchServer(ServerOptions options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  options.load.duration_s = 60 * options.minutes;
  if (options.load.server.empty())
    options.load.server = std::filesystem::read_symlink("/proc/self/exe").replace_filename("insonate-server");
  const auto results = runServerBench(options.load, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeServerBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "server.md");
  return {};
}

constexpr std::array kShapes{ProbeShape::Linear, ProbeShape::Curvilinear, ProbeShape::Phased};

struct RealismOptions : BenchOptions {
  std::string real;
  bool pointSpread = false;
  std::string engine = "cpu";
  std::vector<std::string> ratings, cases, probes, planes;
  SimulatedSet set;
};

Result<void> scoreRatings(const RealismOptions& options) {
  const std::vector<std::filesystem::path> files(options.ratings.begin(), options.ratings.end());
  const auto result = scoreBlindTest(std::filesystem::path(options.folder) / "key.csv", files);
  if (!result) return tl::unexpected(result.error());
  if (options.json) {
    printJson(toJson(*result));
    return {};
  }
  std::printf(
      "%d images, %d readers: sensitivity %.2f, specificity %.2f, ROC area %.2f (95 %% interval %.2f to %.2f)\n",
      result->images, result->readers, result->sensitivity, result->specificity, result->separation.area,
      result->separation.low, result->separation.high);
  for (const BlindGroup& group : result->groups)
    std::printf("  %s, %d real and %d simulated: ROC area %.2f (%.2f to %.2f)\n", group.name.c_str(), group.real,
                group.simulated, group.separation.area, group.separation.low, group.separation.high);
  return {};
}

Result<void> benchPointSpread(const RealismOptions& options) {
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  if (options.probes.size() > 1) return fail("--point-spread takes one --probe.");
  const auto probe = loadProbe(options.probes.empty() ? "linear" : options.probes.front());
  if (!probe) return tl::unexpected(probe.error());
  const auto results = runPointSpreadBench(*probe, options.engine, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writePointSpreadBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "index.md");
  return {};
}

Result<void> benchRealism(const RealismOptions& options) {
  if (options.pointSpread) return benchPointSpread(options);
  if (!options.ratings.empty()) return scoreRatings(options);
  if (auto ok = checkBenchFolder(options.folder); !ok) return ok;
  SimulatedSet set = options.set;
  set.cases.assign(options.cases.begin(), options.cases.end());
  for (const std::string& name : options.probes) {
    const auto shape = std::ranges::find(kShapes, name, [](ProbeShape one) { return nameOf(one); });
    if (shape == kShapes.end())
      return fail("The probe of simulated images is linear, curvilinear or phased, not \"" + name + "\".");
    set.probes.push_back(*shape);
  }
  for (const std::string& name : options.planes)
    if (const auto plane = scanPlaneNamed(name)) set.planes.push_back(*plane);
  auto real = readRealImages(options.real);
  if (!real) return tl::unexpected(real.error());
  const auto results = runRealismBench(std::move(*real), set, terminalProgress());
  if (!results) return tl::unexpected(results.error());
  if (auto ok = writeRealismBench(*results, options.folder); !ok) return ok;
  tell(options, *results, "index.md");
  return {};
}

CLI::App* addCommand(CLI::App& bench, const char* name, const char* description, BenchOptions& options) {
  CLI::App* command = bench.add_subcommand(name, description);
  command->add_option("--out", options.folder, "Folder for tables and plots; a missing folder is created")->required();
  command->add_flag("--quick", options.quick, "Measure with fewer settings and images");
  command->add_flag("--json", options.json, "Print the tables as one JSON object");
  return command;
}

void add(CLI::App& bench, Outcome& outcome, const char* name, const char* description,
         Result<void> (*run)(const BenchOptions&)) {
  auto options = std::make_shared<BenchOptions>();
  addCommand(bench, name, description, *options)->callback([options, &outcome, run] {
    outcome.json = options->json;
    if (auto ok = run(*options); !ok) refuse(outcome, ok.error());
  });
}

void addSegmentation(CLI::App& bench, Outcome& outcome) {
  auto options = std::make_shared<SegmentationOptions>();
  CLI::App* command =
      addCommand(bench, "segmentation",
                 "Measure the accuracy of labeling against reference labels, and the time of the tools", *options);
  command
      ->add_option("--chest-cta", options->plan.chestCta,
                   "Folder with an angiogram of the chest and masks of its vessels")
      ->check(CLI::ExistingDirectory);
  CLI::Option* atlas =
      command->add_option("--atlas", options->plan.atlas, "Label map of an atlas (see phantom --from-labels)")
          ->check(CLI::ExistingFile);
  CLI::Option* map =
      command->add_option("--map", options->plan.atlasMap, "JSON file with the name of each number in the atlas")
          ->check(CLI::ExistingFile)
          ->needs(atlas);
  atlas->needs(map);
  command->add_option("--neck", options->plan.necks,
                      "Name of one built-in neck (see phantom --list); by default all necks, or one neck with --quick");
  command
      ->add_option("--only", options->only,
                   "Run only this part: necks, automatic (vessels, thyroid and muscles without clicks), speed, or none "
                   "(only the data given by the other options)")
      ->check(CLI::IsMember({"necks", "automatic", "speed", "none"}));
  command->callback([options, &outcome] {
    outcome.json = options->json;
    if (auto ok = benchSegmentation(*options); !ok) refuse(outcome, ok.error());
  });
}

void addServer(CLI::App& bench, Outcome& outcome) {
  auto options = std::make_shared<ServerOptions>();
  ServerLoad& load = options->load;
  CLI::App* command = bench.add_subcommand(
      "server", "Load insonate-server with workstations, readers and open pages, and kill it, if asked to");
  command->add_option("--out", options->folder, "Folder for tables; a missing folder is created")->required();
  command->add_option("--server", load.server, "Program insonate-server; by default beside this program")
      ->check(CLI::ExistingFile);
  command->add_option("--database", load.database, "Empty database, postgresql://...; by default a new file");
  command->add_option("--servers", load.servers, "Number of server processes that share the database")
      ->capture_default_str()
      ->check(CLI::Range(1, 16));
  command->add_option("--workstations", load.workstations, "Number of workstations; each sends one attempt")
      ->capture_default_str()
      ->check(CLI::Range(1, 999));
  command->add_option("--trainees", load.trainees, "Number of trainees; at least one for each workstation")
      ->capture_default_str()
      ->check(CLI::Range(1, 5000));
  command->add_option("--minutes", options->minutes, "Duration of the load")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 600.0));
  command->add_option("--recording", load.recording_MB, "Size of a recording, MB")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 64.0));
  command->add_option("--readers", load.readers, "Number of people who read, one page every 5 s each")
      ->capture_default_str()
      ->check(CLI::Range(0, 500));
  command->add_option("--live", load.livePages, "Number of open pages with live refresh")
      ->capture_default_str()
      ->check(CLI::Range(0, 500));
  command->add_option("--kills", load.kills, "Number of times that a server process is killed and started again")
      ->capture_default_str()
      ->check(CLI::Range(0, 10000));
  command->add_option("--crash-database", load.crashDatabase,
                      "Shell command that crashes the database and starts it again, after every second kill");
  command->add_flag("--video", load.withVideo, "Also measure what the video of an attempt costs, after the load");
  command->add_flag("--json", options->json, "Print the tables as one JSON object");
  command->callback([options, &outcome] {
    outcome.json = options->json;
    if (auto ok = benchServer(*options); !ok) refuse(outcome, ok.error());
  });
}

void addRealism(CLI::App& bench, Outcome& outcome) {
  auto options = std::make_shared<RealismOptions>();
  CLI::App* command = bench.add_subcommand(
      "realism", "Compare simulated with real images: features, a classifier, and a blind test with readers");
  command->add_option("--out", options->folder, "Folder for tables and the blind test; a missing folder is created")
      ->required();
  CLI::Option* real = command
                          ->add_option("--real", options->real,
                                       "List of real images, one in each line: file,pixels per "
                                       "mm,source[,left,top,width,height][,probe=...][,plane=...][,fps=...]. The "
                                       "image, or its box, shows only the inside of a linear probe's field of view, "
                                       "without text, or the fan of another probe. A folder of images is a clip")
                          ->check(CLI::ExistingFile);
  CLI::Option* ratings =
      command
          ->add_option(
              "--ratings", options->ratings,
              "Files ratings.csv with the answers of readers, which are compared with key.csv in the folder of --out")
          ->check(CLI::ExistingFile)
          ->excludes(real);
  command->add_option("--count", options->set.count, "Number of simulated images")
      ->capture_default_str()
      ->check(CLI::Range(2, 2000))
      ->excludes(ratings);
  command->add_option("--seed", options->set.seed, "Seed for the random choice of necks, settings and order")
      ->capture_default_str()
      ->excludes(ratings);
  command->add_option("--case", options->cases, "Folders of cases to simulate, in addition to built-in necks")
      ->check(CLI::ExistingDirectory)
      ->excludes(ratings);
  CLI::Option* points = command
                            ->add_flag("--point-spread", options->pointSpread,
                                       "Compare images of points with the computed field of the probe's array: beam "
                                       "widths, side levels, slice thickness and contrast at each depth")
                            ->excludes(real)
                            ->excludes(ratings);
  command
      ->add_option("--probe", options->probes,
                   "Probes of the images, in turn: linear, curvilinear, phased; by default the probes of the real "
                   "images. With --point-spread: one linear probe, as a preset or a file")
      ->excludes(ratings);
  command
      ->add_option("--plane", options->planes,
                   "Planes of the images, in turn: transverse, longitudinal, oblique; by default as in the real images")
      ->check(CLI::IsMember({"transverse", "longitudinal", "oblique"}))
      ->excludes(points)
      ->excludes(ratings);
  command
      ->add_flag("--clips", options->set.clips,
                 "Simulate clips of 1 s (30 frames) only; by default one for each real clip")
      ->excludes(points)
      ->excludes(ratings);
  command->add_option("--engine", options->engine, "Engine: cpu, glsl or reference")
      ->capture_default_str()
      ->needs(points);
  command->add_flag("--json", options->json, "Print the results as one JSON object");
  command->callback([options, real, ratings, points, &outcome] {
    outcome.json = options->json;
    if (!*real && !*ratings && !*points) throw CLI::RequiredError("--real, --ratings or --point-spread");
    if (auto ok = benchRealism(*options); !ok) refuse(outcome, ok.error());
  });
}

}  // namespace

void addBenchCommand(CLI::App& app, Outcome& outcome) {
  CLI::App* bench = app.add_subcommand("bench", "Measure speed and errors, and write tables and plots");
  bench->require_subcommand(1);
  add(*bench, outcome, "ultrasound", "Measure frame times and errors of the ultrasound engines, and realism",
      benchUltrasound);
  add(*bench, outcome, "deformation", "Measure frame times and errors of the deformation models", benchDeformation);
  add(*bench, outcome, "doppler", "Measure errors and cost of color Doppler", benchDoppler);
  add(*bench, outcome, "haptics", "Measure tick times, stability and force curves of the haptic servo", benchHaptics);
  add(*bench, outcome, "wire", "Measure the time of advancing a guidewire, and its error", benchWire);
  add(*bench, outcome, "hands", "Measure errors and time of tracking printed bodies with a camera", benchHands);
  addSegmentation(*bench, outcome);
  addRealism(*bench, outcome);
  addServer(*bench, outcome);
  add(*bench, outcome, "curriculum", "Measure how long the window waits for the store of users and attempts",
      benchCurriculum);
}

}  // namespace insonate::cli
