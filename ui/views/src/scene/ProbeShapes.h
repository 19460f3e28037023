#pragma once

#include <insonate/ultrasound/Probe.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace insonate::views {

/// A transducer in the probe frame (mm): the face's middle at the origin, the body toward -z, the marker at +x.
struct ProbeParts {
  vtkSmartPointer<vtkPolyData> body, lens, marker;
};

ProbeParts probeParts(const Probe& probe);

}  // namespace insonate::views
