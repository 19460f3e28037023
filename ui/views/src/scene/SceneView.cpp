#include "PatientBox.h"
#include "SceneDrawing.h"

#include <insonate/tissue/Labels.h>
#include <insonate/views/LabelColors.h>

#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace insonate::views {
namespace {

SceneShape::Triangles copyOf(const Surface& surface) {
  return {{surface.points_mm.begin(), surface.points_mm.end()},
          {surface.normals.begin(), surface.normals.end()},
          {surface.triangles.begin(), surface.triangles.end()}};
}

}  // namespace

SceneView::SceneView() : drawing_(std::make_unique<Drawing>(*renderer(), [this] { wake(); })) {
  for (const LabelInfo& info : labelTable())
    drawing_->state.looks[info.label] = {labelColor(info.label, ColorScheme::Default), defaultOpacity(info.label)};
}

SceneView::~SceneView() {
  if (window()) detached(*window());
}

void SceneView::attached(vtkRenderWindow& window) {
  drawing_->stage.attach(window);
}

void SceneView::detached(vtkRenderWindow& window) {
  drawing_->stage.detach(window);
}

void SceneView::publishState() {
  frame();
  SceneState& state = drawing_->state;
  state.width_px = width_px(), state.height_px = height_px(), state.scale = scale();
  state.camera = placeOf(*drawing_->usual);
  state.patient = drawing_->patient ? drawing_->patient->shared() : nullptr;
  drawing_->handed = state;
  drawing_->isHanded = true;
}

void SceneView::adoptState() {
  if (!std::exchange(drawing_->isHanded, false)) return;
  std::swap(drawing_->handed, drawing_->taken);
  drawing_->isTaken = true;
}

void SceneView::draw() {
  SceneStage& stage = drawing_->stage;
  if (std::exchange(drawing_->isTaken, false)) stage.show(drawing_->taken);
  drawing_->news = false;
  View::draw();
  drawing_->exact = stage.exact();
  drawing_->render_s = renderer()->GetLastRenderTimeInSeconds();
  const std::lock_guard lock(drawing_->telling);
  if (drawing_->graphics.empty()) drawing_->graphics = stage.rendererName();
}

bool SceneView::isStale() const {
  return drawing_->stage.due();
}

void SceneView::layout() {
  drawing_->stage.layout();
}

std::string SceneView::rendererName() const {
  const std::lock_guard lock(drawing_->telling);
  return drawing_->graphics;
}

double SceneView::renderTime_s() const {
  return drawing_->render_s;
}

void SceneView::setCase(std::shared_ptr<const VtkCase> patient) {
  drawing_->patient = std::move(patient);
  drawing_->framed = false;
  clip();
}

void SceneView::setSurface(std::uint8_t label, const Surface& surface, const Surface& coarse) {
  auto& shape = drawing_->state.shapes[label];
  if (surface.triangles.empty()) {
    if (!shape) return;
    shape = nullptr;
  } else {
    auto made = std::make_shared<SceneShape>();
    made->fine = copyOf(surface), made->coarse = copyOf(coarse);
    pointsBox(made->fine.points_mm, made->box);
    shape = std::move(made);
  }
  if (!drawing_->patient) clip();
  structuresChanged();
}

void SceneView::setColor(std::uint8_t label, Color color) {
  drawing_->state.looks[label].color = color;
  structuresChanged();
}

void SceneView::setOpacity(std::uint8_t label, double opacity) {
  drawing_->state.looks[label].opacity = opacity;
  structuresChanged();
}

void SceneView::setVisible(std::uint8_t label, bool visible) {
  drawing_->state.looks[label].visible = visible;
  structuresChanged();
}

void SceneView::setSkinOpacity(double opacity) {
  setOpacity(kSkin, opacity);
}

std::vector<std::uint8_t> SceneView::structures() const {
  std::vector<std::uint8_t> labels;
  for (std::size_t label = 0; label < drawing_->state.shapes.size(); ++label)
    if (drawing_->state.shapes[label]) labels.push_back(std::uint8_t(label));
  return labels;
}

Color SceneView::color(std::uint8_t label) const {
  return drawing_->state.looks[label].color;
}

double SceneView::opacity(std::uint8_t label) const {
  return drawing_->state.looks[label].opacity;
}

bool SceneView::isVisible(std::uint8_t label) const {
  return drawing_->state.looks[label].visible;
}

void SceneView::setStructuresChanged(std::function<void()> listener) {
  drawing_->structuresChanged = std::move(listener);
}

void SceneView::structuresChanged() {
  changed();
  if (drawing_->structuresChanged) drawing_->structuresChanged();
}

void SceneView::setCtVisible(bool visible) {
  drawing_->state.ctVisible = visible;
  changed();
}

bool SceneView::isCtVisible() const {
  return drawing_->state.ctVisible;
}

void SceneView::setTransferFunction(const TransferFunction& function) {
  drawing_->state.transfer = sortedAndClamped(function);
  changed();
}

const TransferFunction& SceneView::transferFunction() const {
  return drawing_->state.transfer;
}

void SceneView::setProbe(std::optional<Probe> probe, const ImagingSettings& settings) {
  SceneState& state = drawing_->state;
  // The present image has another field of view.
  if (probe) state.image.gray.clear();
  state.probe = std::move(probe);
  state.settings = settings;
  ++state.probeChanges;
  if (drawing_->clipping.kind == ClippingKind::ImagePlane) clip();
  changed();
}

void SceneView::setProbePose(const Transform& patientFromProbe) {
  drawing_->state.patientFromProbe = patientFromProbe;
  if (drawing_->clipping.kind == ClippingKind::ImagePlane) clip();
  changed();
}

void SceneView::setProbeVisible(bool visible) {
  drawing_->state.probeVisible = visible;
  changed();
}

void SceneView::setImagePlaneVisible(bool visible) {
  drawing_->state.planeVisible = visible;
  changed();
}

void SceneView::setImage(const BModeImage& image) {
  drawing_->state.image = image;
  ++drawing_->state.imageChanges;
  changed();
}

const std::optional<SceneView::Needle>& SceneView::needle() const {
  return drawing_->state.needle;
}

void SceneView::setNeedle(std::optional<Needle> needle) {
  drawing_->state.needle = needle;
  ++drawing_->state.needleChanges;
  changed();
}

void SceneView::setTray(const std::optional<Transform>& patientFromTray) {
  drawing_->state.tray = patientFromTray;
  changed();
}

void SceneView::setPaths(std::vector<ScenePath> paths) {
  drawing_->state.paths = std::make_shared<const std::vector<ScenePath>>(std::move(paths));
  changed();
}

void SceneView::setMoving(bool moving) {
  if (moving == drawing_->state.moving) return;
  drawing_->state.moving = moving;
  changed();
}

bool SceneView::isMoving() const {
  return drawing_->state.moving;
}

bool SceneView::isExact() const {
  return !drawing_->state.moving && drawing_->exact;
}

bool SceneView::renderExactly(double patience_s) {
  const bool wasMoving = isMoving();
  const auto start = std::chrono::steady_clock::now();
  setMoving(false);
  render();
  while (!isExact() && std::chrono::steady_clock::now() - start < std::chrono::duration<double>(patience_s)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (drawing_->news) render();
  }
  const bool exact = isExact();
  setMoving(wasMoving);
  return exact;
}

}  // namespace insonate::views
