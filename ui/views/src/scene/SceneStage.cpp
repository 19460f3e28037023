#include "SceneStage.h"

#include "SceneCamera.h"
#include "SceneLights.h"

#include <insonate/tissue/Labels.h>

#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>

#include <utility>

namespace insonate::views {
namespace {

/// Structures inside the body are drawn before the body if both are cut.
constexpr double kInnerLift_mm = 0.1;
constexpr double kWall_px = 2, kCube_px = 84;

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

std::string graphicsOf(vtkRenderWindow& window) {
  const char* words = window.ReportCapabilities();
  const std::string report = words ? words : "", name = "OpenGL renderer string:";
  const std::size_t at = report.find(name);
  if (at == report.npos) return "unknown";
  const std::size_t begin = report.find_first_not_of(' ', at + name.size());
  return report.substr(begin, report.find('\n', begin) - begin);
}

/// Mesa's software renderers.
bool isProcessor(const std::string& graphics) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast"})
    if (graphics.find(name) != graphics.npos) return true;
  return false;
}

bool same(const std::optional<ClippingPlane>& a, const std::optional<ClippingPlane>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->point_mm == b->point_mm && a->normal == b->normal;
}

}  // namespace

SceneStage::SceneStage(vtkRenderer& renderer, std::function<void()> news)
    : renderer_(renderer),
      ct_(renderer),
      plane_(renderer),
      probe_(renderer),
      needle_(renderer),
      path_(renderer),
      tray_(renderer) {
  renderer_.SetBackground(theme::kGround.red / 255.0, theme::kGround.green / 255.0, theme::kGround.blue / 255.0);
  renderer_.SetBackground2(0x20 / 255.0, 0x26 / 255.0, 0x2c / 255.0);
  renderer_.GradientBackgroundOn();
  renderer_.UseFXAAOn();
  addLights(renderer_);
  renderer_.AddObserver(vtkCommand::EndEvent, this, &SceneStage::pictureEnds);
  ct_.setTransferFunction(now_.transfer);
  ct_.setNews(std::move(news));
  probe_.setVisible(false);
  plane_.setVisible(false);
}

void SceneStage::attach(vtkRenderWindow& window) {
  window_ = &window;
  cube_.attach(window);
  // The renderer's own initialization would be too late for its viewport.
  startObserver_ = window.AddObserver(vtkCommand::StartEvent, this, &SceneStage::pictureStarts);
  useStereo(window, now_.stereo);
  due_ = true;
}

void SceneStage::detach(vtkRenderWindow& window) {
  cube_.detach(window);
  window.RemoveObserver(startObserver_);
  detail_.release(window);
  window_ = nullptr;
}

void SceneStage::pictureStarts() {
  detail_.starts(renderer_, now_.moving);
}

void SceneStage::pictureEnds() {
  detail_.ends(renderer_);
}

void SceneStage::show(SceneState& next) {
  std::swap(before_, now_);
  std::swap(now_, next);
  due_ = true;
  showStructures();
  showCt();
  showProbe();
  if (now_.stereo != before_.stereo && window_) useStereo(*window_, now_.stereo);
  // A closed patient is released.
  before_.patient = nullptr;
  before_.shapes.fill(nullptr);
}

void SceneStage::showStructures() {
  const bool otherCut = !same(now_.cut, before_.cut), otherPace = now_.moving != before_.moving;
  for (std::size_t label = 0; label < now_.shapes.size(); ++label) {
    const auto& shape = now_.shapes[label];
    const LabelLook& look = now_.looks[label];
    const bool otherShape = shape != before_.shapes[label];
    if (!shape) {
      if (const auto found = structures_.find(std::uint8_t(label)); found != structures_.end()) {
        found->second.remove(renderer_);
        structures_.erase(found);
      }
      continue;
    }
    const auto [found, isNew] = structures_.try_emplace(std::uint8_t(label));
    Structure& structure = found->second;
    if (isNew) structure.add(renderer_);
    if (otherShape) structure.setShape(shape);
    if (isNew || look != before_.looks[label]) {
      structure.setColor(look.color);
      structure.setOpacity(look.opacity);
      structure.setVisible(look.visible);
    }
    if (isNew || otherCut) structure.setClipping(now_.cut);
    if (otherShape || otherPace) structure.setCoarse(now_.moving);
  }
}

void SceneStage::showCt() {
  // Wraps the array again, since the array of the window's thread may get other memory at any time.
  if (now_.patient != before_.patient) ct_.setCase(now_.patient ? std::make_shared<VtkCase>(now_.patient) : nullptr);
  if (now_.transfer != before_.transfer) ct_.setTransferFunction(now_.transfer);
  if (!same(now_.cut, before_.cut)) ct_.setClipping(now_.cut);
  if (now_.moving != before_.moving) ct_.setCoarse(now_.moving);
  ct_.setVisible(now_.ctVisible);
}

void SceneStage::showProbe() {
  const bool otherProbe = now_.probeChanges != before_.probeChanges;
  if (otherProbe && now_.probe) {
    probe_.setProbe(*now_.probe);
    plane_.setFieldOfView(*now_.probe, now_.settings);
  }
  if (otherProbe || now_.imageChanges != before_.imageChanges) plane_.setImage(now_.image);
  if (now_.patientFromProbe != before_.patientFromProbe) {
    const auto matrix = vtkMatrix(now_.patientFromProbe);
    probe_.setPose(matrix);
    plane_.setPose(matrix);
  }
  probe_.setVisible(now_.probe && now_.probeVisible);
  plane_.setVisible(now_.probe && now_.planeVisible);
  if (now_.needleChanges != before_.needleChanges) needle_.set(now_.needle);
  if (now_.tray != before_.tray) tray_.set(now_.tray);
  if (now_.paths != before_.paths) path_.set(now_.paths ? *now_.paths : std::vector<ScenePath>{});
}

void SceneStage::aim() {
  stand(*usual_, now_.camera);
  if (!now_.coupling) {
    renderer_.SetActiveCamera(usual_);
    renderer_.ResetCameraClippingRange();
    return;
  }
  const HeadCoupling coupling = placed(*now_.coupling, *usual_, now_.width_px, now_.height_px);
  const double half_mm = now_.stereo == Stereo::Off ? 0 : coupling.eyeSeparation_mm / 2;
  const double across_mm = coupled_->GetLeftEye() ? -half_mm : half_mm;
  standBeforeScreen(*coupled_, coupling, across_mm);
  renderer_.SetActiveCamera(coupled_);
  renderer_.ResetCameraClippingRange();
  lookThroughScreen(*coupled_, coupling, across_mm);
}

void SceneStage::layout() {
  due_ = false;
  if (graphics_.empty()) {
    graphics_ = graphicsOf(*window_);
    ct_.setSoftware(isProcessor(graphics_));
  }
  aim();
  cube_.place(now_.width_px, now_.height_px, kCube_px * now_.scale);
  cube_.follow(*renderer_.GetActiveCamera());
  int translucent = 0;
  for (auto& [label, structure] : structures_) {
    translucent += structure.translucent();
    // The skin's surface is that of the whole body and encloses all others.
    structure.close(label == kSkin ? 0 : kInnerLift_mm);
    structure.face().setWall(kWall_px * now_.scale);
  }
  // One translucent surface whose near side is drawn needs no sorting.
  renderer_.SetUseDepthPeeling(translucent > 1 && !now_.moving);
  renderer_.SetMaximumNumberOfPeels(4);
  // Smooth edges cost a fifth of a coarse frame on a processor, and are invisible during motion.
  renderer_.SetUseFXAA(!now_.moving);
}

}  // namespace insonate::views
