#include "ProbeModel.h"

#include "ProbeShapes.h"

#include <insonate/views/Theme.h>

#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace insonate::views {
namespace {

void dress(vtkActor& actor, Color color, double shine) {
  vtkNew<vtkPolyDataMapper> mapper;
  actor.SetMapper(mapper);
  vtkProperty& look = *actor.GetProperty();
  look.SetInterpolationToPhong();
  look.SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
  look.SetAmbient(0.15);
  look.SetDiffuse(0.8);
  look.SetSpecular(shine);
  look.SetSpecularPower(40);
}

}  // namespace

ProbeModel::ProbeModel(vtkRenderer& renderer) : renderer_(renderer) {
  dress(*body_.Get(), {0xd2, 0xd8, 0xde}, 0.25);
  dress(*lens_.Get(), {0x3c, 0x44, 0x4d}, 0.15);
  dress(*marker_.Get(), theme::kAccent, 0.1);
  for (vtkActor* part : {body_.Get(), lens_.Get(), marker_.Get()}) renderer_.AddActor(part);
}

ProbeModel::~ProbeModel() {
  for (vtkActor* part : {body_.Get(), lens_.Get(), marker_.Get()}) renderer_.RemoveActor(part);
}

void ProbeModel::setProbe(const Probe& probe) {
  const ProbeParts parts = probeParts(probe);
  vtkPolyDataMapper::SafeDownCast(body_->GetMapper())->SetInputData(parts.body);
  vtkPolyDataMapper::SafeDownCast(lens_->GetMapper())->SetInputData(parts.lens);
  vtkPolyDataMapper::SafeDownCast(marker_->GetMapper())->SetInputData(parts.marker);
}

void ProbeModel::setPose(vtkMatrix4x4* patientFromProbe) {
  for (vtkActor* part : {body_.Get(), lens_.Get(), marker_.Get()}) part->SetUserMatrix(patientFromProbe);
}

void ProbeModel::setVisible(bool visible) {
  for (vtkActor* part : {body_.Get(), lens_.Get(), marker_.Get()}) part->SetVisibility(visible);
}

}  // namespace insonate::views
