#pragma once

#include <insonate/ultrasound/Probe.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace insonate::views {

/// Shapes of a transducer in the probe's frame (mm): the center of the face at the origin, the body toward -z, the
/// marker at +x.
struct ProbeParts {
  vtkSmartPointer<vtkPolyData> body, lens, marker;
};

ProbeParts probeParts(const Probe& probe);

}  // namespace insonate::views
