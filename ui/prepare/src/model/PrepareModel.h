#pragma once

class QObject;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

class CaseChanges;
class CaseMeasuring;
class Crosshair;
class LabelFollowers;
class LabelSession;
class LivePatient;
class Notice;
class OpenCase;
class PlaceProposing;
class PlacesEditor;
class SliceSettings;
class StatusLine;
class StructureAppearance;
class StructureList;
class TermsEditor;

/// The parts of the model that the workspace's features share. A panel includes the headers of the parts that it uses.
struct PrepareModel {
  OpenCase& openCase;
  Notice& notice;
  CaseMeasuring& measuring;
  LivePatient& live;
  LabelSession& labeling;
  LabelFollowers& followers;
  TermsEditor& terms;
  StructureList& structures;
  StructureAppearance& appearance;
  PlacesEditor& places;
  PlaceProposing& proposing;
  Crosshair& crosshair;
  SliceSettings& slices;
  StatusLine& statusLine;
  CaseChanges& changes;
};

/// Makes the parts as children of `parent`. `tasks` shows long jobs and must outlive the parts.
PrepareModel makePrepareModel(ui::TaskBar& tasks, QObject& parent);

}  // namespace insonate::prepare
