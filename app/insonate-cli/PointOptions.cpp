#include "PointOptions.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace insonate::cli {
namespace {

/// 30 dB over unit speckle: above tissue and fascia, below white at the default gain.
constexpr double kAmplitude = 31.6;
constexpr double kFarthest_mm = 500;

/// Numbers between commas; none where something else is among them.
std::optional<std::vector<double>> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');) {
    const auto last = word.find_last_not_of(" \t\r");
    word.erase(last == std::string::npos ? 0 : last + 1);
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
  }
  return numbers;
}

bool isInFront(Vec3 point_mm) {
  return point_mm.z > 0 && norm(point_mm) < kFarthest_mm;
}

Result<std::vector<PointTarget>> readFile(const std::string& file) {
  std::ifstream in(file);
  if (!in) return fail("--points: cannot read '" + file + "'.");
  std::vector<PointTarget> points;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto values = numbersIn(line);
    const bool isPoint = values && values->size() == 3;
    const Vec3 point_mm = isPoint ? Vec3{(*values)[0], (*values)[1], (*values)[2]} : Vec3{};
    if (!isInFront(point_mm))
      return fail("--points: line " + std::to_string(number) + " of '" + file +
                  "' is not a point; write lateral,elevation,depth in mm, such as 0,0,20, with a depth above 0.");
    points.push_back({point_mm, kAmplitude});
  }
  if (points.empty()) return fail("--points: '" + file + "' has no points.");
  return points;
}

}  // namespace

Result<std::vector<PointTarget>> readPoints(const std::string& listOrFile) {
  std::error_code ignored;
  if (std::filesystem::exists(listOrFile, ignored)) return readFile(listOrFile);
  const auto depths_mm = numbersIn(listOrFile);
  std::vector<PointTarget> points;
  if (depths_mm)
    for (const double depth_mm : *depths_mm)
      if (isInFront({0, 0, depth_mm})) points.push_back({{0, 0, depth_mm}, kAmplitude});
  if (points.empty() || points.size() != depths_mm->size())
    return fail("--points: '" + listOrFile +
                "' is neither a file nor a list of depths above 0 in mm; write 10,20,30, for example.");
  return points;
}

}  // namespace insonate::cli
