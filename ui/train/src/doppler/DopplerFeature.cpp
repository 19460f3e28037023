#include "DopplerFeature.h"

#include "../layout/ControlsColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "ColorBox.h"
#include "ColorControls.h"

#include <insonate/ui/ViewWidget.h>

#include <QSettings>
#include <QWidget>
#include <cmath>

namespace insonate::train {
namespace {

struct ColorKey {
  const char* key;  ///< of the stored value
  double ColorSettings::*field;
};
constexpr ColorKey kColorKeys[] = {{"colorPrf", &ColorSettings::prf_Hz},
                                   {"colorGain", &ColorSettings::gain_dB},
                                   {"colorSteering", &ColorSettings::steering_deg},
                                   {"wallFilter", &ColorSettings::wallFilter_Hz}};

}  // namespace

DopplerFeature::DopplerFeature(TrainModel& model, TrainLayout& layout) : Feature(model, layout) {
  beginSection(KeySection::Image);
  addCommand(
      {.id = "train.doppler.color",
       .text = tr("Color Doppler"),
       .does = tr("switches color Doppler on or off"),
       .listed = tr("Ctrl+D"),
       .keys = keys({Qt::Key_D}, Qt::ControlModifier),
       .perform = once([this] { model_.imaging.setColor(!model_.imaging.isColorOn(), model_.imaging.color()); })});
  commands().addListed(tr("Left drag on the color box"),
                       tr("moves the box by its border, and resizes it by its corners"));
  layout.controls().addSection(new ColorControls(model.imaging, commands()));
  new ColorBox(model.imaging, layout.views().image(), *layout.views().imageWidget().focusProxy(), this);
}

void DopplerFeature::save(QSettings& settings) const {
  for (const auto& [key, field] : kColorKeys) settings.setValue(key, model_.imaging.color().*field);
}

/// Color is off at first: a session begins with the B-mode image.
void DopplerFeature::restore(QSettings& settings) {
  ColorSettings color = model_.imaging.color();
  for (const auto& [key, field] : kColorKeys) {
    bool ok = false;
    const double value = settings.value(key).toDouble(&ok);
    if (ok && std::isfinite(value)) color.*field = value;
  }
  model_.imaging.setColor(model_.imaging.isColorOn(), color);
}

}  // namespace insonate::train
