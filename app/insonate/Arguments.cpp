#include "Arguments.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <vector>

namespace insonate::app {
namespace {

constexpr int kLeast_px = 320, kMost_px = 8192;

/// "1600x1000"; empty sentence when it is one.
std::string readSize(const std::string& text, int& width, int& height) {
  const char* end = text.data() + text.size();
  const auto [afterWidth, e1] = std::from_chars(text.data(), end, width);
  const bool separated = e1 == std::errc() && afterWidth != end && *afterWidth == 'x';
  const auto [afterHeight, e2] = std::from_chars(separated ? afterWidth + 1 : end, end, height);
  const auto fits = [](int side) { return side >= kLeast_px && side <= kMost_px; };
  if (separated && e2 == std::errc() && afterHeight == end && fits(width) && fits(height)) return {};
  return "must be WIDTHxHEIGHT in pixels, each " + std::to_string(kLeast_px) + " to " + std::to_string(kMost_px);
}

}  // namespace

std::variant<Arguments, int> parseArguments(int argc, char** argv) {
  Arguments a;
  std::string screenshot;
  CLI::App parser{"Insonate computes ultrasound images from a patient's CT and shows them in a window."};
  parser.set_version_flag("--version", std::string(INSONATE_VERSION));
  parser.add_option("CASE", a.caseFolder,
                    "Case folder, DICOM folder, volume file or recorded attempt to open; by default the built-in neck");
  parser.add_option("--workspace", a.workspace, "Workspace to show first")
      ->check(CLI::IsMember(std::vector<std::string>{"prepare", "train", "review"}));
  auto* shot =
      parser.add_option("--screenshot", screenshot, "Write a PNG of the window when it shows the case, and quit");
  parser
      .add_option_function<std::string>(
          "--size",
          [&a](const std::string& text) {
            if (const std::string wrong = readSize(text, a.width_px, a.height_px); !wrong.empty())
              throw CLI::ValidationError("--size", wrong);
          },
          "Size of the screenshot, e.g. 1600x1000")
      ->needs(shot);
  parser.add_option("--database", a.database,
                    "Database of people and attempts: a file; by default the file in the environment variable "
                    "INSONATE_DATABASE, or else the file in the user's data folder");
  parser.add_option("--as", a.person,
                    "Sign in as this user, with the password in the environment variable INSONATE_PASSWORD");
  std::string benchmark;
  auto* bench =
      parser.add_option("--benchmark", benchmark,
                        "Measure the window's speed, write window.json and window.csv to this folder, and quit");
  parser.add_flag("--quick", a.quick, "With --benchmark: a short run, to check that the benchmark works")->needs(bench);
  auto* image = parser.add_flag("--until-image", a.untilImage,
                                "Print the milliseconds from the start to the first live image, and quit");
  bench->excludes(shot)->excludes(image);
  image->excludes(shot);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return parser.exit(e) == 0 ? 0 : 2;
  }
  a.screenshot = screenshot;
  a.benchmark = benchmark;
  return a;
}

}  // namespace insonate::app
