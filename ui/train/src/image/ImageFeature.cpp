#include "ImageFeature.h"

#include "../layout/ControlsColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "CineBar.h"
#include "CtBeside.h"
#include "EffectWords.h"
#include "EqualPanes.h"
#include "FreezeButton.h"
#include "ImageExports.h"
#include "ImageInput.h"
#include "ImagePanel.h"
#include "LinkedPointer.h"
#include "Measurements.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Workspace.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QAction>
#include <QLabel>
#include <QSettings>
#include <algorithm>
#include <span>
#include <utility>

namespace insonate::train {

ImageFeature::ImageFeature(TrainModel& model, TrainLayout& layout, QWidget& probeChooser)
    : Feature(model, layout,
              {Command::Freeze, Command::EarlierPicture, Command::LaterPicture, Command::SavePicture,
               Command::MeasureDistance, Command::MeasureEllipse, Command::MeasureAngle, Command::StopMeasuring,
               Command::ClearMeasures, Command::NextEffect, Command::WholePicture, Command::CtBeside}),
      panel_(new ImagePanel(model.disclosure, model.imaging, probeChooser)),
      // The key table has the key; the menu only names it.
      besideAction_(layout.addAction(tr("CT beside the image\tC"), tr("The same plane of the CT at the same scale"))) {
  layout.controls().addSection(panel_);
  layout.controls().setFoot(new FreezeButton(model.patientCase, model.live));
  buildColumn();
  buildInput();
  connectModel();
  showCase();
}

void ImageFeature::buildColumn() {
  ImageColumn& column = layout_.image();
  empty_ = new QLabel(&column);
  empty_->setObjectName("emptyState");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  beside_ = new CtBeside(model_.patientCase, model_.live, &column);
  panes_ = new EqualPanes(&column);
  panes_->add(&layout_.views().imageWidget());
  panes_->add(&beside_->widget());
  vesselNote_ = new QLabel(
      tr("This case has no vein and no artery, so the image shows none. Label them under Prepare, or in 3D Slicer or "
         "ITK-SNAP and reload the case there (F5)."));
  vesselNote_->setObjectName("vesselNote");
  vesselNote_->setWordWrap(true);
  vesselNote_->setContentsMargins(12, ui::kSmallGap, 12, ui::kSmallGap);
  ui::setRole(vesselNote_, "quiet");
  cine_ = new CineBar(model_.patientCase, model_.live, &column);
  column.add(ImageColumn::Image, empty_);
  column.add(ImageColumn::Image, panes_);
  column.add(ImageColumn::Note, vesselNote_);
  column.add(ImageColumn::Bar, cine_);
}

void ImageFeature::buildInput() {
  SharedViews& views = layout_.views();
  views.addSlice({&beside_->view(), &beside_->widget()});
  QWidget& canvas = *views.imageWidget().focusProxy();
  auto* input = new ImageInput(model_.imaging, model_.motion, model_.needle, views.image(), canvas, this);
  measurements_ = new Measurements(model_.status, model_.history, views, *input, *cine_, this);
  auto* pointer = new LinkedPointer(model_.patientCase, model_.live, views.image(), canvas, this);
  const auto addToPointer = [pointer](const SharedViews::Slice& slice) {
    pointer->addSlice(*slice.view, *slice.widget->focusProxy());
  };
  for (const SharedViews::Slice& slice : views.slices()) addToPointer(slice);
  connect(&views, &SharedViews::sliceAdded, pointer, addToPointer);
  exports_ = new ImageExports({model_.patientCase, model_.live, model_.status, *cine_, *input, *panes_},
                              layout_.workspace(), this);
}

void ImageFeature::connectModel() {
  SharedViews& views = layout_.views();
  connect(&model_.patientCase, &CaseModel::caseChanged, this, [this] { showCase(); });
  connect(&model_.patientCase, &CaseModel::structuresKnown, this, [this] { showPlacing(); });
  connect(&model_.motion, &ProbeMotion::placingChanged, this, [this] { showPlacing(); });
  connect(&model_.live, &LiveModel::pictureShown, this, [this] { showImage(); });
  connect(&model_.live, &LiveModel::frozenChanged, this, [this] { showFrozen(); });
  connect(&model_.imaging, &ImagingModel::setupChanged, this, [this] { showNotice(); });
  connect(&model_.disclosure, &DisclosureModel::changed, this, [this] {
    const bool anatomy = model_.disclosure.current().anatomy;
    if (!anatomy) besideAction_->setChecked(false);
    cine_->setCtBesideOffered(anatomy);
    besideAction_->setEnabled(anatomy);
  });
  connect(&views, &SharedViews::boundsChanged, this, [this] {
    shape_ = nullptr;
    if (model_.live.shown()) showImage();
  });
  connect(&views, &SharedViews::windowLevelChanged, this,
          [this](views::WindowLevel value) { beside_->view().setWindowLevel(value); });
  connect(cine_, &CineBar::ctBesideChosen, this, [this](bool on) { setCtBeside(on); });
  connect(besideAction_, &QAction::toggled, this, [this](bool on) { setCtBeside(on); });
}

void ImageFeature::act(const KeyRow& row, KeyPress press) {
  switch (row.command) {
    case Command::Freeze:
      return press.repeated ? void() : model_.live.setFrozen(!model_.live.isFrozen());
    case Command::EarlierPicture:
      return model_.live.showCine(model_.live.cineIndex() - 1);
    case Command::LaterPicture:
      return model_.live.showCine(model_.live.cineIndex() + 1);
    case Command::SavePicture:
      return exports_->askPicture();
    case Command::MeasureDistance:
      return measurements_->choose(int(views::CalliperKind::Distance));
    case Command::MeasureEllipse:
      return measurements_->choose(int(views::CalliperKind::Ellipse));
    case Command::MeasureAngle:
      return measurements_->choose(int(views::CalliperKind::Angle));
    case Command::StopMeasuring:
      return measurements_->choose(-1);
    case Command::ClearMeasures:
      return measurements_->clear();
    case Command::NextEffect:
      return model_.imaging.stepEffect(press.wide ? -1 : 1);
    case Command::WholePicture:
      return model_.imaging.setEffect(ImagingModel::kWholeModel);
    case Command::CtBeside:
      return setCtBeside(!besideAction_->isChecked());
    default:
      return;
  }
}

bool ImageFeature::isAvailable(Command command) const {
  return Feature::isAvailable(command) && (command != Command::StopMeasuring || measurements_->isMeasuring());
}

void ImageFeature::showCase() {
  views::UltrasoundView& image = layout_.views().image();
  shape_ = nullptr;
  isImageThere_ = false;
  image.setImage({});
  image.setFrozen(false);
  layout_.views().imageWidget().forget();
  beside_->widget().forget();
  measurements_->forget();
  empty_->setVisible(!model_.patientCase.patient());
  showPlacing();
  setOpening({});
  showNotice();
}

void ImageFeature::showPlacing() {
  const CaseModel& patientCase = model_.patientCase;
  panes_->setVisible(patientCase.patient() && !model_.motion.isUnplaced());
  vesselNote_->setVisible(patientCase.patient() && patientCase.lacksVessels());
}

void ImageFeature::setOpening(const QString& what) {
  empty_->setText(what.isEmpty()
                      ? tr("No case is open.\n\nDrop a case, a folder of DICOM files or a CT file on the window,\n"
                           "or choose Case > Open case (Ctrl+O), or Case > Built-in neck (Ctrl+T).")
                      : tr("%1 ...").arg(what));
}

void ImageFeature::setCompact(bool isCompact) {
  cine_->setCompact(isCompact);
}

void ImageFeature::showImage() {
  const LiveFrame& frame = *model_.live.shown();
  views::UltrasoundView& image = layout_.views().image();
  const bool isFirst = !std::exchange(isImageThere_, true);
  image.setImage(frame.image);
  if (frame.setup != shape_) {
    const BeamGrid grid(frame.setup->probe, frame.setup->settings);
    const auto bounds =
        layout_.views().boundsFor({grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()});
    if (bounds) {
      shape_ = frame.setup;
      image.setBounds(*bounds);
      image.setFocus(shape_->settings.focus_mm);
      const auto& tgc_dB = shape_->settings.tgc_dB;
      const bool flat = std::ranges::all_of(tgc_dB, [](double dB) { return dB == 0; });
      image.setTgc(flat ? std::span<const double>() : std::span<const double>(tgc_dB));
    }
  }
  if (isFirst) showNotice();
}

void ImageFeature::showNotice() {
  const std::string& effect = model_.imaging.effect();
  const bool isOneEffect = effect != ImagingModel::kWholeModel;
  QString words = isOneEffect ? tr("ONLY %1").arg(effectWords(effect)) : QString();
  if (!model_.live.shown()) words = tr("Building the first image ...");
  layout_.views().image().setNotice(words.toStdString());
  if (std::exchange(isOneEffect_, isOneEffect) == isOneEffect && !isOneEffect) return;
  model_.status.say(isOneEffect ? tr("The image shows one effect only; 0 shows the whole image.")
                                : tr("The whole image is shown."));
}

void ImageFeature::showFrozen() {
  layout_.views().image().setFrozen(model_.live.isFrozen());
  // Measurements lie on the frozen image.
  if (!model_.live.isFrozen()) measurements_->clearImage();
}

void ImageFeature::setCtBeside(bool isShown) {
  if (isShown && !model_.disclosure.mayShowAnatomy()) return besideAction_->setChecked(false);
  besideAction_->setChecked(isShown);
  // Leaving the full size of a view would show what was visible before.
  layout_.views().restoreSizes();
  beside_->setShown(isShown);
  cine_->setCtBeside(isShown);
}

void ImageFeature::save(QSettings& settings) const {
  settings.setValue("ctBeside", besideAction_->isChecked());
  exports_->save(settings);
  panel_->save(settings);
}

void ImageFeature::restore(QSettings& settings) {
  setCtBeside(settings.value("ctBeside", false).toBool());
  exports_->restore(settings);
  panel_->restore(settings);
}

}  // namespace insonate::train
