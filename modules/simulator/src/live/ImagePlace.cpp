#include <insonate/simulator/ImagePlace.h>

namespace insonate {

bool showsPlaceOf(const LiveFrame& frame, const Transform& patientFromProbe) {
  const BModeImage& image = frame.image;
  for (const double column : {0.0, image.width - 1.0})
    for (const double row : {0.0, image.height - 1.0}) {
      const Vec3 corner{image.left_mm + column * image.pixel_mm, 0, image.top_mm + row * image.pixel_mm};
      if (norm(frame.patientFromProbe * corner - patientFromProbe * corner) > kSamePlace_mm) return false;
    }
  return true;
}

}  // namespace insonate
