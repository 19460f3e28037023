#pragma once

#include <insonate/procedure/LineInstruments.h>

#include <QString>

namespace insonate::train {

/// Returns the name of an act as a menu entry: "Detach syringe". `lumen`: 1 to 3, for the acts at a lumen.
QString titleOf(LineAct act, int lumen = 1);
/// Returns "Needle", "Wire", "Dilator" or "Catheter".
QString titleOf(Instrument instrument);

}  // namespace insonate::train
