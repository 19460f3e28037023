#include "SceneDrawing.h"

#include <insonate/tissue/Labels.h>

#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>

namespace insonate::views {
namespace {

/// A key above the camera and a soft fill from below, moving with it.
void addLights(vtkRenderer& renderer) {
  renderer.AutomaticLightCreationOff();
  const struct { double x, y, z, intensity; } lights[] = {{-0.35, 0.6, 1, 0.85}, {0.5, -0.35, 0.6, 0.28}};
  for (const auto& light : lights) {
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToCameraLight();
    lamp->SetPosition(light.x, light.y, light.z);
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetIntensity(light.intensity);
    renderer.AddLight(lamp);
  }
}

}  // namespace

SceneView::SceneView() : drawing_(std::make_unique<Drawing>(*renderer())) {
  renderer()->SetBackground(theme::kGround.red / 255.0, theme::kGround.green / 255.0, theme::kGround.blue / 255.0);
  renderer()->SetBackground2(0x20 / 255.0, 0x26 / 255.0, 0x2c / 255.0);
  renderer()->GradientBackgroundOn();
  renderer()->UseFXAAOn();
  addLights(*renderer());
  for (const LabelInfo& info : labelTable())
    drawing_->looks[info.label].colour = {info.colour[0], info.colour[1], info.colour[2]};
  drawing_->looks[kSkin].opacity = 0.35;
  drawing_->probe.setVisible(false);
  drawing_->plane.setVisible(false);
}

SceneView::~SceneView() {
  if (window()) detached(*window());
}

void SceneView::attached(vtkRenderWindow& window) {
  drawing_->cube.attach(window);
  useStereo(window, drawing_->stereo);
}

void SceneView::detached(vtkRenderWindow& window) {
  drawing_->cube.detach(window);
}

void SceneView::setCase(std::shared_ptr<const VtkCase> patient) {
  drawing_->patient = std::move(patient);
  drawing_->ct.set(drawing_->patient.get(), drawing_->ctLook);
  drawing_->framed = false;
  changed();
}

void SceneView::setSurface(std::uint8_t label, const Surface& surface, const Surface& coarse) {
  auto found = drawing_->structures.find(label);
  if (surface.triangles.empty()) {
    if (found == drawing_->structures.end()) return;
    renderer()->RemoveActor(found->second.actor());
    drawing_->structures.erase(found);
  } else {
    if (found == drawing_->structures.end()) {
      found = drawing_->structures.try_emplace(label).first;
      renderer()->AddActor(found->second.actor());
    }
    const LabelLook& look = drawing_->looks[label];
    Structure& structure = found->second;
    structure.setSurface(surface, coarse);
    structure.setColour(look.colour);
    structure.setOpacity(look.opacity);
    structure.setVisible(look.visible);
    structure.setClipping(drawing_->clipping);
    structure.setCoarse(drawing_->moving);
  }
  changed();
}

void SceneView::setColour(std::uint8_t label, Colour colour) {
  drawing_->looks[label].colour = colour;
  if (auto found = drawing_->structures.find(label); found != drawing_->structures.end())
    found->second.setColour(colour);
  changed();
}

void SceneView::setOpacity(std::uint8_t label, double opacity) {
  drawing_->looks[label].opacity = opacity;
  if (auto found = drawing_->structures.find(label); found != drawing_->structures.end())
    found->second.setOpacity(opacity);
  changed();
}

void SceneView::setVisible(std::uint8_t label, bool visible) {
  drawing_->looks[label].visible = visible;
  if (auto found = drawing_->structures.find(label); found != drawing_->structures.end())
    found->second.setVisible(visible);
  changed();
}

void SceneView::setSkinOpacity(double opacity) {
  setOpacity(kSkin, opacity);
}

void SceneView::setCtLook(CtLook look) {
  drawing_->ctLook = look;
  drawing_->ct.set(drawing_->patient.get(), look);
  changed();
}

void SceneView::setClipping(std::optional<ClippingPlane> plane) {
  drawing_->clipping = plane;
  for (auto& [label, structure] : drawing_->structures) structure.setClipping(plane);
  drawing_->ct.setClipping(plane);
  changed();
}

void SceneView::setProbe(std::optional<Probe> probe, const ImagingSettings& settings) {
  drawing_->hasProbe = probe.has_value();
  if (probe) {
    drawing_->probe.setProbe(*probe);
    drawing_->plane.setFieldOfView(*probe, settings);
  }
  setProbeVisible(drawing_->probeVisible);
  setImagePlaneVisible(drawing_->planeVisible);
}

void SceneView::setProbePose(const Transform& patientFromProbe) {
  const auto matrix = vtkMatrix(patientFromProbe);
  drawing_->probe.setPose(matrix);
  drawing_->plane.setPose(matrix);
  changed();
}

void SceneView::setProbeVisible(bool visible) {
  drawing_->probeVisible = visible;
  drawing_->probe.setVisible(visible && drawing_->hasProbe);
  changed();
}

void SceneView::setImagePlaneVisible(bool visible) {
  drawing_->planeVisible = visible;
  drawing_->plane.setVisible(visible && drawing_->hasProbe);
  changed();
}

void SceneView::setImage(const BModeImage& image) {
  drawing_->plane.setImage(image);
  wantRender();
}

void SceneView::setNeedle(std::optional<Needle> needle) {
  drawing_->needle.set(needle);
  changed();
}

void SceneView::setMoving(bool moving) {
  if (moving == drawing_->moving) return;
  drawing_->moving = moving;
  for (auto& [label, structure] : drawing_->structures) structure.setCoarse(moving);
  drawing_->ct.setCoarse(moving);
  changed();
}

}  // namespace insonate::views
