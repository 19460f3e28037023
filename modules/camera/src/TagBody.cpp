#include <insonate/camera/TagBody.h>
#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/embedded/hands.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace insonate {
namespace {

constexpr double kFlat_mm = 0.05, kMaxBody_mm = 500;
constexpr std::size_t kMaxVertices = 200;

Vec3 readVector(JsonEntry& entry, const char* key, double limit) {
  const auto v = entry.numbers(key, 3, -limit, limit, "[x, y, z]");
  return v.size() == 3 ? Vec3{v[0], v[1], v[2]} : Vec3{};
}

std::vector<Vec3> readVertices(JsonEntry& entry) {
  std::vector<Vec3> vertices;
  const nlohmann::json& list = entry.value("vertices_mm");
  if (!list.is_array() || list.size() > kMaxVertices) {
    entry.setError("needs 'vertices_mm' as a list of 4 to 200 points [x, y, z].");
    return vertices;
  }
  for (const auto& point : list) {
    Vec3 vertex;
    const bool isPoint = point.is_array() && point.size() == 3 &&
                         std::ranges::all_of(point, [](const nlohmann::json& n) { return n.is_number(); });
    for (int axis = 0; isPoint && axis < 3; ++axis) vertex[axis] = point[std::size_t(axis)].get<double>();
    if (!isPoint || !(norm(vertex) <= kMaxBody_mm))
      entry.setError("has an entry in 'vertices_mm' that is not a point [x, y, z] within 500 mm.");
    vertices.push_back(vertex);
  }
  return vertices;
}

std::vector<std::vector<int>> readFaces(JsonEntry& entry, std::size_t vertices) {
  std::vector<std::vector<int>> faces;
  const nlohmann::json& list = entry.value("faces");
  const auto isIndex = [&](const nlohmann::json& n) {
    return n.is_number_integer() && n.get<std::int64_t>() >= 0 && n.get<std::int64_t>() < std::int64_t(vertices);
  };
  const bool isList = list.is_array() && list.size() >= 4 && list.size() <= kMaxVertices;
  for (std::size_t f = 0; isList && f < list.size(); ++f) {
    const nlohmann::json& face = list[f];
    if (!face.is_array() || face.size() < 3 || face.size() > kMaxVertices || !std::ranges::all_of(face, isIndex)) {
      faces.clear();
      break;
    }
    faces.push_back(face.get<std::vector<int>>());
  }
  if (faces.empty()) entry.setError("needs 'faces' as a list of lists of three or more indices of vertices, from 0.");
  return faces;
}

Vec3 middleOf(const std::vector<Vec3>& corners) {
  Vec3 sum;
  for (const Vec3& corner : corners) sum = sum + corner;
  return sum / double(corners.size());
}

Vec3 normalOf(const std::vector<Vec3>& corners) {
  const Vec3 middle = middleOf(corners);
  Vec3 sum;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum = sum + cross(corners[i] - middle, corners[(i + 1) % corners.size()] - middle);
  return normalized(sum);
}

/// Checks that the faces form a closed convex surface with outward normals.
Result<void> checkShape(const TagBody& body, const std::string& where) {
  std::set<std::pair<int, int>> edges;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    const auto& face = body.faces[f];
    const std::vector<Vec3> corners = cornersOf(body, int(f));
    const Vec3 normal = normalOf(corners), middle = middleOf(corners);
    const std::string name = where + "face " + std::to_string(f);
    if (!isFinite(normal)) return fail(name + " has no area; correct its vertices.");
    for (const Vec3& corner : corners)
      if (!(std::abs(dot(corner - middle, normal)) <= kFlat_mm))
        return fail(name + " is not flat within 0.05 mm; correct its vertices.");
    for (const Vec3& vertex : body.vertices_mm)
      if (!(dot(vertex - middle, normal) <= kFlat_mm))
        return fail(name +
                    " has vertices of the body in front of it. The body must be convex, and the vertices of a face "
                    "must be in counterclockwise order as seen from outside.");
    for (std::size_t i = 0; i < face.size(); ++i)
      if (!edges.insert({face[i], face[(i + 1) % face.size()]}).second)
        return fail(name + " shares an edge with two other faces; correct the lists of vertices.");
  }
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a}))
      return fail(where + "the edge between the vertices " + std::to_string(a) + " and " + std::to_string(b) +
                  " has a face on one side only; add the missing face.");
  return {};
}

struct TurnedTag {
  BodyTag tag;
  double turn_deg = 0, right_mm = 0, up_mm = 0;
};

/// Sets the pose of a tag: in the middle of its face, its upper side toward the face's first vertex, then turned and
/// shifted.
Result<void> placeTag(const TagBody& body, const TurnedTag& turned, BodyTag& tag, const std::string& where) {
  const std::vector<Vec3> corners = cornersOf(body, tag.face);
  const Vec3 z = normalOf(corners), middle = middleOf(corners);
  const Vec3 first = normalized(corners.front() - middle - z * dot(corners.front() - middle, z));
  const double turn = turned.turn_deg * std::numbers::pi / 180;
  const Vec3 y = first * std::cos(turn) + cross(z, first) * std::sin(turn);
  tag.bodyFromTag = {{{cross(y, z), y, z}}, middle + cross(y, z) * turned.right_mm + y * turned.up_mm};
  for (const Vec3& corner : cornersOf(tag)) {
    const Vec3 p = tag.bodyFromTag * corner;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 along = normalized(corners[(i + 1) % corners.size()] - corners[i]);
      if (dot(cross(z, along), p - corners[i]) < 0)
        return fail(where + " does not fit into its face; reduce its size_mm.");
    }
  }
  return {};
}

Result<void> placeTags(TagBody& body, const std::vector<TurnedTag>& tags, const std::string& where) {
  std::set<int> ids;
  if (tags.empty()) return fail(where + "it has no tags; add at least one.");
  for (const TurnedTag& turned : tags) {
    BodyTag tag = turned.tag;
    if (!ids.insert(tag.id).second)
      return fail(where + "the tag " + std::to_string(tag.id) + " appears twice; give each tag an id of its own.");
    if (auto ok = placeTag(body, turned, tag, where + "tag " + std::to_string(tag.id)); !ok) return ok;
    body.tags.push_back(tag);
  }
  return {};
}

Transform readTool(const nlohmann::json& json, std::string& error) {
  JsonEntry entry(json, "The tool of the body", {"origin_mm", "z", "x"}, error);
  const Vec3 origin = readVector(entry, "origin_mm", kMaxBody_mm);
  const Vec3 z = readVector(entry, "z", 1), x = readVector(entry, "x", 1);
  constexpr double kPerpendicular = 1e-3;
  if (!(norm(z) > 0) || !(norm(x) > 0) || std::abs(dot(z, x)) > kPerpendicular * norm(x) * norm(z)) {
    entry.setError("needs 'z' and 'x' as two directions that are perpendicular.");
    return {};
  }
  const Vec3 unitZ = normalized(z), y = normalized(cross(unitZ, x));
  return {{{cross(y, unitZ), y, unitZ}}, origin};
}

}  // namespace

std::array<Vec3, 4> cornersOf(const BodyTag& tag) {
  const double h = tag.size_mm / 2;
  return {{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}};
}

std::vector<Vec3> cornersOf(const TagBody& body, int face) {
  std::vector<Vec3> corners;
  for (const int vertex : body.faces[std::size_t(face)]) corners.push_back(body.vertices_mm[std::size_t(vertex)]);
  return corners;
}

Result<TagBody> parseTagBody(std::string_view text) {
  const auto json = parsedJson(text, "The body");
  if (!json) return tl::unexpected(json.error());
  std::string error;
  JsonEntry entry(*json, "The body", {"name", "description", "vertices_mm", "faces", "tags", "tool"}, error);
  TagBody body;
  body.name = entry.text("name"), body.description = entry.text("description", false);
  body.vertices_mm = readVertices(entry);
  body.faces = readFaces(entry, body.vertices_mm.size());
  const auto readTag = [&](const nlohmann::json& object, const std::string& where, std::string& trouble) {
    JsonEntry tag(object, where, {"id", "face", "size_mm", "turn_deg", "shift_mm"}, trouble);
    TurnedTag turned;
    turned.tag.id = tag.integer("id", 0, kTagCount - 1);
    turned.tag.face = tag.integer("face", 0, std::max(0, int(body.faces.size()) - 1));
    turned.tag.size_mm = tag.number("size_mm", 1, kMaxBody_mm);
    turned.turn_deg = tag.optionalNumber("turn_deg", -360, 360).value_or(0);
    if (!tag.has("shift_mm")) return turned;
    const auto shift = tag.numbers("shift_mm", 2, -kMaxBody_mm, kMaxBody_mm, "[right, up]");
    turned.right_mm = shift[0], turned.up_mm = shift[1];
    return turned;
  };
  const auto tags = entry.list("tags", "tag", readTag);
  body.bodyFromTool = readTool(entry.value("tool"), error);
  if (!error.empty()) return fail(error);
  const std::string where = "The body '" + body.name + "': ";
  if (auto ok = checkShape(body, where); !ok) return tl::unexpected(ok.error());
  if (auto ok = placeTags(body, tags, where); !ok) return tl::unexpected(ok.error());
  return body;
}

std::vector<std::string> tagBodyNames() {
  return presetNames(embeddedPresets(embedded::hands::files()));
}

Result<TagBody> loadTagBody(std::string_view nameOrPath) {
  return presetOrFile("a body with tags", nameOrPath, embeddedPresets(embedded::hands::files()), parseTagBody);
}

}  // namespace insonate
