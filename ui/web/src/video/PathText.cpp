#include "video/PathText.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace insonate::web {
namespace {

using nlohmann::json;

constexpr const char *kPathTime = "t_us", *kArea = "area_mm", *kPixel = "pixel_mm", *kColumns = "columns",
                     *kRows = "rows", *kLabels = "labels", *kPieces = "pieces", *kPlace = "place", *kSlice = "in_slice",
                     *kPoints = "points";
constexpr int kMostPixels = 4'000'000;

double hundredths(double value_mm) {
  return std::round(value_mm * 100) / 100;
}

/// Runs of equal labels: label, length, label, length, ...
json runsOf(const std::vector<std::uint8_t>& labels) {
  json runs = json::array();
  for (std::size_t begin = 0; begin < labels.size();) {
    std::size_t end = begin + 1;
    while (end < labels.size() && labels[end] == labels[begin]) ++end;
    runs.push_back(labels[begin]), runs.push_back(end - begin);
    begin = end;
  }
  return runs;
}

SectionLabels labelsFrom(const json& object) {
  SectionLabels section{.columns = object.at(kColumns), .rows = object.at(kRows)};
  const std::int64_t count = std::int64_t{section.columns} * section.rows;
  if (section.columns < 0 || section.rows < 0 || count > kMostPixels) return {};
  const json& runs = object.at(kLabels);
  for (std::size_t i = 0; i + 1 < runs.size(); i += 2) {
    const std::int64_t length = runs[i + 1];
    if (length < 0 || std::int64_t(section.labels.size()) + length > count) return {};
    section.labels.insert(section.labels.end(), std::size_t(length), runs[i].get<std::uint8_t>());
  }
  return std::int64_t(section.labels.size()) == count ? section : SectionLabels{};
}

PathPiece pieceFrom(const json& object) {
  PathPiece piece{.place = static_cast<NeedlePlace>(object.at(kPlace).get<int>()), .isInSlice = object.at(kSlice)};
  for (const json& one : object.at(kPoints))
    piece.points.push_back({one.at(0).get<std::int64_t>(),
                            Vec3{one.at(1).get<double>(), one.at(2).get<double>(), one.at(3).get<double>()}});
  return piece;
}

}  // namespace

json pathToJson(const NeedlePath& path) {
  json pieces = json::array();
  for (const PathPiece& piece : path.pieces) {
    json points = json::array();
    for (const PathPiece::Point& point : piece.points)
      points.push_back(
          {point.time_us, hundredths(point.tip_probe.x), hundredths(point.tip_probe.y), hundredths(point.tip_probe.z)});
    pieces.push_back(
        {{kPlace, static_cast<int>(piece.place)}, {kSlice, piece.isInSlice}, {kPoints, std::move(points)}});
  }
  return {{kPathTime, path.time_us},     {kArea, {path.area.left, path.area.right, path.area.top, path.area.bottom}},
          {kPixel, path.pixel_mm},       {kColumns, path.structures.columns},
          {kRows, path.structures.rows}, {kLabels, runsOf(path.structures.labels)},
          {kPieces, std::move(pieces)}};
}

std::optional<NeedlePath> pathFromJson(const json& object) {
  try {
    const auto area = object.at(kArea).get<std::array<double, 4>>();
    NeedlePath path{.time_us = object.at(kPathTime),
                    .area = {area[0], area[1], area[2], area[3]},
                    .pieces = {},
                    .pixel_mm = object.at(kPixel),
                    .structures = labelsFrom(object)};
    for (const json& one : object.at(kPieces)) path.pieces.push_back(pieceFrom(one));
    return path;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace insonate::web
