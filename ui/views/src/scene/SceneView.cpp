#include "SceneDrawing.h"
#include "SceneLights.h"

#include <insonate/tissue/Labels.h>
#include <insonate/views/LabelColours.h>

#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>

#include <chrono>
#include <thread>

namespace insonate::views {
namespace {

void addLights(vtkRenderer& renderer) {
  renderer.AutomaticLightCreationOff();
  for (const SceneLight& light : kSceneLights) {
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
  renderer()->AddObserver(vtkCommand::EndEvent, this, &SceneView::pictureEnds);
  for (const LabelInfo& info : labelTable())
    drawing_->looks[info.label] = {labelColour(info.label, ColourScheme::Usual), usualOpacity(info.label)};
  drawing_->ct.setTransferFunction(drawing_->transfer);
  drawing_->ct.setNews([this] { wake(); });
  drawing_->probe.setVisible(false);
  drawing_->plane.setVisible(false);
}

SceneView::~SceneView() {
  if (window()) detached(*window());
}

void SceneView::attached(vtkRenderWindow& window) {
  drawing_->cube.attach(window);
  // The renderer's own start would be too late for its viewport.
  drawing_->startObserver = window.AddObserver(vtkCommand::StartEvent, this, &SceneView::pictureStarts);
  useStereo(window, drawing_->stereo);
}

void SceneView::detached(vtkRenderWindow& window) {
  drawing_->cube.detach(window);
  window.RemoveObserver(drawing_->startObserver);
  drawing_->detail.release(window);
}

void SceneView::pictureStarts() {
  drawing_->detail.starts(*renderer(), drawing_->moving);
}

void SceneView::pictureEnds() {
  drawing_->detail.ends(*renderer());
}

void SceneView::setCase(std::shared_ptr<const VtkCase> patient) {
  drawing_->patient = std::move(patient);
  drawing_->ct.setCase(drawing_->patient);
  drawing_->framed = false;
  clip();
}

void SceneView::setSurface(std::uint8_t label, const Surface& surface, const Surface& coarse) {
  auto found = drawing_->structures.find(label);
  if (surface.triangles.empty()) {
    if (found == drawing_->structures.end()) return;
    found->second.remove(*renderer());
    drawing_->structures.erase(found);
  } else {
    if (found == drawing_->structures.end()) {
      found = drawing_->structures.try_emplace(label).first;
      found->second.add(*renderer());
    }
    const LabelLook& look = drawing_->looks[label];
    Structure& structure = found->second;
    structure.setSurface(surface, coarse);
    structure.setColour(look.colour);
    structure.setOpacity(look.opacity);
    structure.setVisible(look.visible);
    structure.setClipping(drawing_->cut);
    structure.setCoarse(drawing_->moving);
  }
  if (!drawing_->patient) clip();
  structuresChanged();
}

void SceneView::setColour(std::uint8_t label, Colour colour) {
  drawing_->looks[label].colour = colour;
  if (auto found = drawing_->structures.find(label); found != drawing_->structures.end())
    found->second.setColour(colour);
  structuresChanged();
}

void SceneView::setOpacity(std::uint8_t label, double opacity) {
  drawing_->looks[label].opacity = opacity;
  if (auto found = drawing_->structures.find(label); found != drawing_->structures.end())
    found->second.setOpacity(opacity);
  structuresChanged();
}

void SceneView::setVisible(std::uint8_t label, bool visible) {
  drawing_->looks[label].visible = visible;
  if (auto found = drawing_->structures.find(label); found != drawing_->structures.end())
    found->second.setVisible(visible);
  structuresChanged();
}

void SceneView::setSkinOpacity(double opacity) {
  setOpacity(kSkin, opacity);
}

std::vector<std::uint8_t> SceneView::structures() const {
  std::vector<std::uint8_t> labels;
  for (const auto& [label, structure] : drawing_->structures) labels.push_back(label);
  return labels;
}

Colour SceneView::colour(std::uint8_t label) const {
  return drawing_->looks[label].colour;
}

double SceneView::opacity(std::uint8_t label) const {
  return drawing_->looks[label].opacity;
}

bool SceneView::isVisible(std::uint8_t label) const {
  return drawing_->looks[label].visible;
}

void SceneView::setStructuresChanged(std::function<void()> listener) {
  drawing_->structuresChanged = std::move(listener);
}

void SceneView::structuresChanged() {
  changed();
  if (drawing_->structuresChanged) drawing_->structuresChanged();
}

void SceneView::setCtVisible(bool visible) {
  drawing_->ctVisible = visible;
  drawing_->ct.setVisible(visible);
  changed();
}

bool SceneView::isCtVisible() const {
  return drawing_->ctVisible;
}

void SceneView::setTransferFunction(const TransferFunction& function) {
  drawing_->transfer = tidied(function);
  drawing_->ct.setTransferFunction(drawing_->transfer);
  changed();
}

const TransferFunction& SceneView::transferFunction() const {
  return drawing_->transfer;
}

void SceneView::setProbe(std::optional<Probe> probe, const ImagingSettings& settings) {
  drawing_->hasProbe = probe.has_value();
  if (drawing_->clipping.kind == ClippingKind::ImagePlane) clip();
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
  drawing_->patientFromProbe = patientFromProbe;
  if (drawing_->clipping.kind == ClippingKind::ImagePlane) clip();
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

bool SceneView::isMoving() const {
  return drawing_->moving;
}

bool SceneView::isExact() const {
  return !drawing_->moving && drawing_->ct.exact();
}

bool SceneView::renderExactly(double patience_s) {
  const bool wasMoving = isMoving();
  const auto start = std::chrono::steady_clock::now();
  setMoving(false);
  render();
  while (!isExact() && std::chrono::steady_clock::now() - start < std::chrono::duration<double>(patience_s)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (drawing_->ct.hasNews()) render();
  }
  const bool exact = isExact();
  setMoving(wasMoving);
  return exact;
}

}  // namespace insonate::views
