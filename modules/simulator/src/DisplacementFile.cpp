#include <insonate/core/AtomicFile.h>
#include <insonate/simulator/DisplacementFile.h>

#include <bit>
#include <cstring>
#include <sstream>
#include <string>

namespace insonate {
namespace {

std::string header(const PlaneDisplacement& d, const Transform& patientFromProbe) {
  const Vec3 lateral = patientFromProbe.linear.column[0], axial = patientFromProbe.linear.column[2];
  const Vec3 origin = patientFromProbe * Vec3{d.left_mm, 0, d.top_mm};
  std::ostringstream text;
  text.precision(12);
  const auto vector = [&text](Vec3 v) { text << '(' << v.x << ',' << v.y << ',' << v.z << ')'; };
  text << "NRRD0005\n"
       << "# From where tissue is seen to where it lay at rest, mm, patient LPS. Made by Insonate.\n"
       << "type: float\n"
       << "dimension: 4\n"
       << "space: left-posterior-superior\n"
       << "sizes: 3 " << d.columns << ' ' << d.rows << " 1\n"
       << "space directions: none ";
  vector(lateral * d.step_mm);
  text << ' ';
  vector(axial * d.step_mm);
  text << ' ';
  vector(cross(lateral, axial) * d.step_mm);
  text << "\nkinds: vector domain domain domain\n"
       << "space units: \"mm\" \"mm\" \"mm\"\n"
       << "space origin: ";
  vector(origin);
  text << "\nencoding: raw\n"
       << "endian: " << (std::endian::native == std::endian::little ? "little" : "big") << "\n\n";
  return text.str();
}

}  // namespace

Result<void> writeDisplacement(const PlaneDisplacement& displacement, const Transform& patientFromProbe,
                               const std::filesystem::path& file) {
  if (displacement.empty()) return fail("Could not write " + file.string() + ": nothing has moved.");
  std::string bytes = header(displacement, patientFromProbe);
  bytes.reserve(bytes.size() + displacement.restFromDisplayed.size() * 3 * sizeof(float));
  for (const PlaneDisplacement::Shift& shift : displacement.restFromDisplayed) {
    const Vec3 vector = patientFromProbe.linear * Vec3{shift.x_mm, 0, shift.z_mm};
    const float components[3] = {static_cast<float>(vector.x), static_cast<float>(vector.y),
                                 static_cast<float>(vector.z)};
    bytes.append(reinterpret_cast<const char*>(components), sizeof components);
  }
  return writeAtomically(file, bytes);
}

}  // namespace insonate
