#include "MeasuringUpdates.h"

#include "CaseMeasuring.h"
#include "OpenCase.h"
#include "PlacesEditor.h"
#include "TermsEditor.h"

namespace insonate::prepare {
namespace {

/// Delay after the last of several edits.
constexpr int kRecheck_ms = 700;

}  // namespace

MeasuringUpdates::MeasuringUpdates(OpenCase& openCase, const PlacesEditor& places, const TermsEditor& terms,
                                   CaseMeasuring& measuring, QObject* parent)
    : QObject(parent) {
  recheck_.setSingleShot(true);
  recheck_.setInterval(kRecheck_ms);
  connect(&openCase, &OpenCase::opened, this, [this, &openCase, &measuring] {
    recheck_.stop();
    measuring.setCase(openCase.patient());
  });
  connect(&places, &PlacesEditor::edited, &recheck_, qOverload<>(&QTimer::start));
  connect(&terms, &TermsEditor::ownLabelsEdited, &recheck_, qOverload<>(&QTimer::start));
  connect(&recheck_, &QTimer::timeout, this, [&openCase, &places, &terms, &measuring] {
    if (openCase.patient()) measuring.setWords(places.value(), terms.value());
  });
}

}  // namespace insonate::prepare
