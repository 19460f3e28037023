#include "LinkedPointer.h"

#include <insonate/ui/CanvasInput.h>

#include <QMouseEvent>
#include <cmath>

namespace insonate::train {
namespace {

/// The image shows what is nearer to its plane than this.
constexpr double kNear_mm = 1;

}  // namespace

LinkedPointer::LinkedPointer(CaseModel& patientCase, LiveModel& live, views::UltrasoundView& picture, QWidget& canvas,
                             QObject* parent)
    : QObject(parent), patientCase_(patientCase), live_(live), picture_(picture), canvas_(canvas) {
  ui::CanvasInput::of(canvas).add(ui::InputRank::Observer, *this);
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] { mark(nullptr, std::nullopt); });
}

void LinkedPointer::addSlice(views::MprView& slice, QWidget& canvas) {
  slices_.push_back({&slice, &canvas});
  ui::CanvasInput::of(canvas).add(ui::InputRank::Observer, *this);
}

bool LinkedPointer::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Leave) mark(watched, std::nullopt);
  if (event->type() == QEvent::MouseMove) {
    const auto& move = *static_cast<QMouseEvent*>(event);
    const double ratio = canvas_.devicePixelRatioF();
    // A hand that drags looks at what it drags.
    const bool points = move.buttons() == Qt::NoButton;
    mark(watched, points ? placeAt(watched, {(move.localPos().x() + 0.5) * ratio, (move.localPos().y() + 0.5) * ratio})
                         : std::nullopt);
  }
  return false;
}

std::optional<Vec3> LinkedPointer::placeAt(QObject* canvas, views::DisplayPoint at) const {
  if (!live_.shown()) return std::nullopt;
  if (canvas == &canvas_) {
    if (!picture_.isOnImage(at)) return std::nullopt;
    const views::ImagePoint point = picture_.imageFromDisplay(at);
    return live_.shown()->patientFromProbe * Vec3{point.lateral_mm, 0, point.axial_mm};
  }
  for (const Slice& slice : slices_)
    if (canvas == slice.canvas) return slice.view->patientFromDisplay(at);
  return std::nullopt;
}

void LinkedPointer::mark(QObject* from, std::optional<Vec3> patient_mm) {
  for (const Slice& slice : slices_) slice.view->setPointer(slice.canvas == from ? std::nullopt : patient_mm);
  std::optional<views::ImagePoint> inPicture;
  if (patient_mm && from != &canvas_ && live_.shown()) {
    const Vec3 place = inverted(live_.shown()->patientFromProbe) * *patient_mm;
    const views::ImagePoint point{place.x, place.z};
    if (std::abs(place.y) < kNear_mm && picture_.isOnImage(picture_.displayFromImage(point))) inPicture = point;
  }
  picture_.setPointer(inPicture);
}

}  // namespace insonate::train
