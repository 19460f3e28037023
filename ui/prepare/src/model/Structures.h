#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/views/Theme.h>

#include <QPixmap>
#include <QString>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace insonate::prepare {

/// Appearance of a structure.
struct StructureLook {
  views::Color color;
  double opacity = 1;   ///< opacity of the structure's surface in 3D, 0 to 1
  bool visible = true;  ///< true: the structure is drawn in 3D and over the slices
  double onSlices = 1;  ///< opacity over the slices, as a fraction (0 to 1) of the opacity that all labels share
  bool operator==(const StructureLook&) const = default;
};

/// Appearance of each structure, by label.
using StructureLooks = std::array<StructureLook, 256>;

/// Returns the default appearance of each structure: the case's color, and an opacity at which the skin and other
/// filling tissue are translucent.
StructureLooks defaultLooks(const LabelColors& colors);
double defaultOpacity(std::uint8_t label);
/// Returns the default of StructureLook::onSlices. Labels that fill the patient are fainter, since an artery has nearly
/// the color of the muscle around it.
double defaultShareOnSlices(std::uint8_t label);

/// Tells whether the color of any of these structures differs from the case's.
bool colorsDiffer(const StructureLooks& looks, const std::vector<std::uint8_t>& structures, const LabelColors& colors);
/// Writes the structures' colors into a case's colors, which contain only those that differ from the label table's.
void putColors(const StructureLooks& looks, const std::vector<std::uint8_t>& structures, LabelColors& colors);

using ShownStructures = std::map<std::uint8_t, SurfaceAppearance>;
void takeShown(const ShownStructures& shown, StructureLooks& looks);
/// Tells whether the opacity or visibility of any of these structures differs.
bool shownDiffers(const StructureLooks& a, const StructureLooks& b, const std::vector<std::uint8_t>& structures);
/// Writes the structures' opacity and visibility into the case's.
void putShown(const StructureLooks& looks, const std::vector<std::uint8_t>& structures, ShownStructures& shown);

/// Returns a structure's name, "vein"; "label 37" for a label without a meaning.
QString structureName(std::uint8_t label);
/// Formats a volume with a suitable number of digits.
QString volumeText(double volume_ml);
/// Returns a small square in a structure's color.
QPixmap swatch(views::Color color);

inline views::Color viewColor(const LabelColor& c) {
  return {c[0], c[1], c[2]};
}
inline LabelColor labelColor(views::Color c) {
  return {c.red, c.green, c.blue};
}

}  // namespace insonate::prepare
