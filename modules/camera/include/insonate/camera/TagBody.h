#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Number of cells along a side of a tag of the family 25h9: without and with the white border.
inline constexpr int kTagCells = 7, kTagCellsWithBorder = 9;
/// Number of tags in the family 25h9; ids are 0 to 34.
inline constexpr int kTagCount = 35;

/// The cells of one tag, row by row from the top left, with the white border; 1: white, 0: black.
using TagPattern = std::array<std::uint8_t, std::size_t(kTagCellsWithBorder) * kTagCellsWithBorder>;

/// Returns the printed cells of a tag of the family 25h9. `id` is 0 to kTagCount - 1.
const TagPattern& tagPattern(int id);

/// A square tag on a body. The tag frame has its origin in the middle of the tag, x to the right and y up as the tag is
/// read, z out of the body.
struct BodyTag {
  int id = 0;          ///< number in the family 25h9
  double size_mm = 0;  ///< side of the black square
  int face = 0;        ///< face of the body on which the tag is printed
  Transform bodyFromTag;
};

/// A rigid convex polyhedron with tags on its faces that the user holds as probe or needle. The body frame has its
/// origin inside; mm. The tool frame is the probe frame (origin at the center of the face, x lateral, z into the body),
/// or has its origin at the needle's tip and z along the shaft, away from the hand.
struct TagBody {
  std::string name, description;
  std::vector<Vec3> vertices_mm;
  std::vector<std::vector<int>> faces;  ///< indices of vertices, counterclockwise as seen from outside
  std::vector<BodyTag> tags;
  Transform bodyFromTool;
};

/// Returns the corners of a tag in the tag frame, in the order of the detector: bottom left, bottom right, top right,
/// top left.
std::array<Vec3, 4> cornersOf(const BodyTag& tag);

/// Returns the corners of a face in the body frame, mm.
std::vector<Vec3> cornersOf(const TagBody& body, int face);

/// Reads a body from JSON. Fails with a sentence if the polyhedron is not closed and convex with flat faces, if a tag
/// does not fit into its face, or if two tags have the same id.
Result<TagBody> parseTagBody(std::string_view json);

/// Returns the names of the bodies that are compiled into the program: "needle", "probe".
std::vector<std::string> tagBodyNames();
/// Returns the built-in body with this name, else reads the file with this path.
Result<TagBody> loadTagBody(std::string_view nameOrPath);

}  // namespace insonate
