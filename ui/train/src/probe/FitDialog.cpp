#include "FitDialog.h"

#include "FitCanvas.h"
#include "ProbeLibrary.h"

#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QImageReader>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

namespace insonate::train {
namespace {

constexpr int kSide_px = 260;
constexpr int kMost_px = 16384;

GrayImage grayOf(const QImage& image) {
  const QImage gray = image.convertToFormat(QImage::Format_Grayscale8);
  GrayImage picture{gray.width(), gray.height(), {}};
  picture.gray.reserve(std::size_t(gray.width()) * gray.height());
  for (int row = 0; row < gray.height(); ++row)
    picture.gray.insert(picture.gray.end(), gray.constScanLine(row), gray.constScanLine(row) + gray.width());
  return picture;
}

Result<QImage> readImage(const QString& file) {
  QImageReader reader(file);
  reader.setAutoTransform(true);  // photographs say how the camera was held
  const QSize size = reader.size();
  if (size.width() > kMost_px || size.height() > kMost_px)
    return fail(file.toStdString() + " has more than 16384 pixels in width or height; make the image smaller.");
  QImage image = reader.read();
  if (image.isNull())
    return fail(file.toStdString() + " is not an image that can be read (" + reader.errorString().toStdString() +
                "). Use PNG or JPEG.");
  return image;
}

QString imageFileIn(const QMimeData& data) {
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) return url.toLocalFile();
  return {};
}

QPushButton* sideButton(const QString& text, const char* object, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(object);
  made->setToolTip(tip);
  made->setAutoDefault(false);
  return made;
}

}  // namespace

struct FitDialog::Loaded {
  QImage picture;
  Result<FovFit> fit = fail("");
};

FitDialog::FitDialog(const Probe& base, QWidget* parent)
    : QDialog(parent), base_(base), probe_(base), canvas_(new FitCanvas), tasks_(new ui::TaskBar) {
  setObjectName("fitDialog");
  setWindowTitle(tr("Fit probe geometry to an image"));
  setAcceptDrops(true);
  canvas_->setInvitation(
      tr("Drop a photograph or screen capture of a scanner's image here, paste an image (Ctrl+V), or open a "
         "file.\n\nThe image is not stored."));
  auto* row = new QHBoxLayout;
  row->setSpacing(16);
  row->addWidget(canvas_, 1);
  row->addWidget(buildSide());
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(16, 16, 16, 16);
  box->addWidget(tasks_);
  box->addLayout(row, 1);
  connect(canvas_, &FitCanvas::shapeChanged, this, &FitDialog::showShape);
  resize(1040, 640);
  showShape();
}

FitDialog::~FitDialog() = default;

QWidget* FitDialog::buildSide() {
  auto* side = new QWidget;
  side->setFixedWidth(kSide_px);
  auto* box = new QVBoxLayout(side);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(8);
  auto* open = sideButton(tr("Open..."), "fitOpen", tr("Opens an image file (PNG, JPEG or BMP)"));
  auto* pasteButton = sideButton(tr("Paste"), "fitPaste", tr("Pastes the image from the clipboard (Ctrl+V)"));
  auto* sources = new QHBoxLayout;
  sources->addWidget(open);
  sources->addWidget(pasteButton);
  shape_ = new QComboBox;
  shape_->setObjectName("fitShape");
  shape_->addItems({tr("linear"), tr("curvilinear"), tr("phased")});
  shape_->setAccessibleName(tr("Shape of the field of view"));
  shape_->setToolTip(tr("Shape of the field of view"));
  rotation_ =
      new ui::ValueSlider(tr("rotation"), QStringLiteral("\u00b0"), {-10, 10, 0, 0.1, 1},
                          tr("rotation of the field of view in the loaded image; the probe geometry is not rotated"));
  rotation_->setObjectName("fitRotation");
  depth_ = new ui::ValueSlider(
      tr("image depth"), QStringLiteral("mm"), {10, 400, base_.defaultDepth_mm, 1, 1},
      tr("distance from the center of the probe face to the bottom of the image, as shown on the scanner"));
  depth_->setObjectName("fitDepth");
  marks_ = new ui::ValueSlider(tr("mark spacing"), QStringLiteral("mm"), {0.5, 50, 10, 0.5, 1},
                               tr("distance between two marks of the image's depth scale"));
  marks_->setObjectName("fitMarks");
  draw_ = sideButton(tr("Set scale by two marks..."), "fitDraw",
                     tr("Click two marks of the depth scale in the image, then type their distance in mm"));
  line_ = new ui::ValueSlider(tr("distance"), QStringLiteral("mm"), {0.5, 400, 10, 0.5, 1},
                              tr("distance between the two clicked points"));
  line_->setObjectName("fitLine");
  values_ = new QLabel;
  values_->setObjectName("fitValues");
  values_->setTextFormat(Qt::PlainText);
  error_ = new QLabel;
  notes_ = new QLabel;
  ui::setRole(error_, "problem");
  ui::setRole(notes_, "quiet");
  for (QLabel* label : {error_, notes_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
  }
  error_->hide();
  take_ = sideButton(tr("Apply"), "fitTake", tr("Uses this geometry for the probe that is being edited"));
  ui::setRole(take_, "primary");
  auto* cancel = sideButton(tr("Cancel"), "fitCancel", tr("Leaves the probe unchanged (Escape)"));
  auto* foot = new QHBoxLayout;
  foot->addWidget(cancel);
  foot->addWidget(take_);
  box->addLayout(sources);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{shape_, rotation_, depth_, marks_, draw_, line_, values_, error_, notes_})
    box->addWidget(widget);
  box->addStretch();
  box->addLayout(foot);
  connectSide(open, pasteButton, cancel);
  return side;
}

void FitDialog::connectSide(QPushButton* open, QPushButton* pasteButton, QPushButton* cancel) {
  connect(open, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Open scanner image"), {},
                                                      tr("Images (*.png *.jpg *.jpeg *.bmp);;All files (*)"));
    if (!file.isEmpty()) openPicture(file);
  });
  connect(pasteButton, &QPushButton::clicked, this, &FitDialog::paste);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(take_, &QPushButton::clicked, this, &FitDialog::takeOver);
  connect(shape_, qOverload<int>(&QComboBox::activated), this, &FitDialog::chooseShape);
  connect(depth_, &ui::ValueSlider::valueChanged, this, &FitDialog::depthTyped);
  connect(marks_, &ui::ValueSlider::valueChanged, this, &FitDialog::marksTyped);
  connect(draw_, &QPushButton::clicked, this, &FitDialog::drawLine);
  connect(canvas_, &FitCanvas::lineDrawn, this, &FitDialog::lineDrawn);
  connect(line_, &ui::ValueSlider::valueChanged, this, &FitDialog::lineTyped);
  connect(rotation_, &ui::ValueSlider::valueChanged, this, [this](double turned) {
    if (refreshing_ || !canvas_->shape()) return;
    FovShape shape = *canvas_->shape();
    shape.rotation_deg = turned;
    canvas_->setShape(shape);
    showShape();
  });
}

bool FitDialog::isWorking() const {
  return tasks_->isRunning();
}

QString FitDialog::message() const {
  return error_->isHidden() ? notes_->text() : error_->text();
}

void FitDialog::say(const QString& sentence, bool error) {
  (error ? error_ : notes_)->setText(sentence);
  error_->setVisible(error);
  notes_->setVisible(!error);
}

void FitDialog::openPicture(const QString& file) {
  load(tr("Fitting"), [file] { return readImage(file); });
}

void FitDialog::paste() {
  const QMimeData* held = QApplication::clipboard()->mimeData();
  if (held && held->hasImage()) {
    const QImage image = qvariant_cast<QImage>(held->imageData());
    if (!image.isNull()) return load(tr("Fitting"), [image]() -> Result<QImage> { return image; });
  }
  if (const QString file = held ? imageFileIn(*held) : QString(); !file.isEmpty()) return openPicture(file);
  say(tr("The clipboard holds no image. Copy an image, then paste again."), true);
}

void FitDialog::load(const QString& title, std::function<Result<QImage>()> read) {
  say(tr("Looking for the field of view in the image."), false);
  tasks_->run<std::shared_ptr<Loaded>>(
      title,
      [read = std::move(read)](const Progress& progress) -> Result<std::shared_ptr<Loaded>> {
        auto image = read();
        if (!image) return tl::unexpected(image.error());
        if (!report(progress, "Looking for the field of view", 0.3)) return fail(std::string(kCancelled));
        auto loaded = std::make_shared<Loaded>();
        loaded->picture = std::move(*image);
        loaded->fit = fitFov(grayOf(loaded->picture));
        return loaded;
      },
      [this](Result<std::shared_ptr<Loaded>> result) { fitted(std::move(result)); });
}

void FitDialog::fitted(Result<std::shared_ptr<Loaded>> result) {
  if (!result) {
    const bool stopped = result.error().message == kCancelled;
    QString sentence = stopped ? tr("Stopped.") : QString::fromStdString(result.error().message);
    if (!picture_.isNull()) sentence += QLatin1Char('\n') + tr("The previous image is still shown.");
    say(sentence, !stopped);
    // The fit's warnings are part of the state, too.
    if (picture_.isNull()) return;
    notes_->setText(stopped ? sentence + QLatin1Char('\n') + doubts_ : doubts_);
    return notes_->show();
  }
  Loaded& loaded = **result;
  picture_ = loaded.picture;
  canvas_->setPicture(picture_);
  canvas_->setMarks({});
  canvas_->setLine(std::nullopt);
  canvas_->setDrawing(false);
  ruler_ = std::nullopt;
  typedDepth_mm_ = depth_->value();
  if (!loaded.fit) {
    placeByHand();
    doubts_ = QString::fromStdString(loaded.fit.error().message);
    return say(doubts_, true);
  }
  FovFit& fit = *loaded.fit;
  canvas_->setShape(fit.shape);
  QStringList doubts;
  for (const std::string& doubt : fit.warnings) doubts << QString::fromStdString(doubt);
  if (fit.ruler) {
    canvas_->setMarks(fit.ruler->at);
    ruler_ = fit.ruler;
    typedDepth_mm_ = 0;
    mmPerPx_ = fit.ruler->mmPerMark / fit.ruler->spacing_px;
    doubts << tr("%1 marks of a depth scale were found; check whether the mark spacing in mm is right.")
                  .arg(fit.ruler->marks);
  }
  if (!fit.ruler)
    doubts << tr("The depth is assumed to be %1 mm until you type the depth.").arg(typedDepth_mm_, 0, 'f', 0);
  if (fit.confidence < 0.5) doubts.prepend(tr("The fit is uncertain. Drag the handles of the outline to correct it."));
  doubts_ = doubts.join(QLatin1Char('\n'));
  say(doubts_, fit.confidence < 0.5);
  showShape();
}

/// A shape of the base's kind in the middle of the image, to be dragged into place.
void FitDialog::placeByHand() {
  FovShape shape;
  const double wide = picture_.width(), high = picture_.height();
  shape.shape = base_.shape;
  shape.width_px = 0.6 * wide, shape.depth_px = 0.8 * high;
  shape.alpha_deg = base_.fovAngle_deg;
  shape.r1_px = base_.shape == ProbeShape::Curvilinear ? 0.25 * high : 0;
  shape.r2_px = shape.r1_px + 0.8 * high;
  shape.origin = {wide / 2, base_.shape == ProbeShape::Linear ? 0.1 * high : 0.1 * high - shape.r1_px};
  canvas_->setShape(shape);
  showShape();
}

void FitDialog::showShape() {
  refreshing_ = true;
  const auto& shape = canvas_->shape();
  for (QWidget* widget : std::initializer_list<QWidget*>{shape_, rotation_, depth_})
    widget->setEnabled(shape.has_value());
  marks_->setVisible(ruler_.has_value());
  draw_->setEnabled(shape.has_value());
  line_->setVisible(line_px() > 0);
  take_->setEnabled(shape.has_value());
  QString text;
  if (shape) {
    // A typed depth stays what it is while the end is dragged; a depth scale stays what it is, too.
    if (typedDepth_mm_ > 0) mmPerPx_ = typedDepth_mm_ / depthOf_px(*shape);
    shape_->setCurrentIndex(int(shape->shape));
    rotation_->setValue(shape->rotation_deg);
    if (ruler_) marks_->setValue(mmPerPx_ * ruler_->spacing_px);
    if (line_px() > 0) line_->setValue(mmPerPx_ * line_px());
    depth_->setValue(depthOf_px(*shape) * mmPerPx_);
    const auto length = [&](double px) { return tr("%1 mm").arg(px * mmPerPx_, 0, 'f', 1); };
    text = shape->shape == ProbeShape::Linear ? tr("width %1").arg(length(shape->width_px))
                                              : tr("angle %1\u00b0\nr1 %2\nr2 %3")
                                                    .arg(shape->alpha_deg, 0, 'f', 1)
                                                    .arg(length(shape->r1_px), length(shape->r2_px));
  }
  values_->setText(text);
  refreshing_ = false;
}

void FitDialog::chooseShape(int chosen) {
  if (!canvas_->shape()) return;
  FovShape shape = *canvas_->shape();
  const ProbeShape before = std::exchange(shape.shape, ProbeShape(chosen));
  const bool wasFan = before != ProbeShape::Linear, fan = shape.shape != ProbeShape::Linear;
  if (wasFan != fan) {
    base_.shape = shape.shape;
    base_.fovAngle_deg = loadProbe(chosen == int(ProbeShape::Phased) ? "phased" : "curvilinear")->fovAngle_deg;
    return placeByHand();
  }
  if (shape.shape == ProbeShape::Phased) shape.r1_px = 0;
  canvas_->setShape(shape);
  showShape();
}

void FitDialog::depthTyped(double depth_mm) {
  if (refreshing_) return;
  typedDepth_mm_ = depth_mm;
  showShape();
}

void FitDialog::marksTyped(double mm) {
  if (refreshing_ || !ruler_) return;
  typedDepth_mm_ = 0;
  mmPerPx_ = mm / ruler_->spacing_px;
  showShape();
}

double FitDialog::line_px() const {
  constexpr double kLeast_px = 3;
  if (!canvas_->line() || canvas_->isDrawing()) return 0;
  const auto& [from, to] = *canvas_->line();
  const double px = std::hypot(to.x - from.x, to.y - from.y);
  return px > kLeast_px ? px : 0;
}

void FitDialog::drawLine() {
  canvas_->setLine(std::nullopt);
  canvas_->setDrawing(true);
  canvas_->setFocus();
  showShape();
  say(tr("Click two marks of the depth scale in the image."), false);
}

void FitDialog::lineDrawn() {
  showShape();
  if (line_px() <= 0) {
    canvas_->setLine(std::nullopt);
    return say(tr("The two points are the same; click two marks that are apart."), true);
  }
  say(tr("Type the distance between the two marks in millimeters."), false);
  line_->setFocus();
}

void FitDialog::lineTyped(double mm) {
  if (refreshing_ || line_px() <= 0) return;
  typedDepth_mm_ = 0;
  mmPerPx_ = mm / line_px();
  showShape();
}

void FitDialog::takeOver() {
  if (!canvas_->shape()) return;
  const char* preset = canvas_->shape()->shape == ProbeShape::Linear        ? "linear"
                       : canvas_->shape()->shape == ProbeShape::Curvilinear ? "curvilinear"
                                                                            : "phased";
  // The beam of another shape would not suit.
  const Probe base = canvas_->shape()->shape == probe_.shape ? probe_ : loadProbe(preset).value_or(probe_);
  // Under a built-in name it could not be saved.
  const std::string name = isBuiltIn(probe_.name) ? tr("probe from an image").toStdString() : probe_.name;
  auto made = probeFromFit(*canvas_->shape(), mmPerPx_, base, name);
  if (!made) return say(QString::fromStdString(made.error().message), true);
  probe_ = std::move(*made);
  accept();
}

void FitDialog::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasImage() || !imageFileIn(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void FitDialog::dropEvent(QDropEvent* event) {
  if (const QString file = imageFileIn(*event->mimeData()); !file.isEmpty()) return openPicture(file);
  const QImage image = qvariant_cast<QImage>(event->mimeData()->imageData());
  if (!image.isNull()) load(tr("Fitting"), [image]() -> Result<QImage> { return image; });
}

void FitDialog::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Paste)) return paste();
  // Return in a number must not take over.
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return;
  QDialog::keyPressEvent(event);
}

}  // namespace insonate::train
