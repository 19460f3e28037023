#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/views/LabelColours.h>
#include <insonate/views/SceneView.h>

#include <QTimer>
#include <QWidget>
#include <map>
#include <memory>

class QCheckBox;
class QSettings;

namespace insonate::ui {

class ClippingControls;
class EyeControls;
class HistogramEditor;
class StructureList;
class ValueSlider;

/// Controls of a 3D view: skin transparency, structures, the CT with its transfer function, a clipping plane, stereo
/// and the head-coupled view. During a change the view is drawn at lower resolution, until the control has not moved
/// for a moment. The panel is narrow and long: put it into a QScrollArea. For the window's thread.
///
/// The scene notifies the panel of surfaces and their appearance: the panel takes over SceneView::setStructuresChanged.
/// A scene therefore has one panel, which also shows changes made elsewhere.
class ScenePanel : public QWidget {
  Q_OBJECT

 public:
  /// Place of the controls that show, hide, color and fade structures, including the skin.
  enum class Structures {
    Here,
    Elsewhere,  ///< the controls of structures are elsewhere; this panel does not change structures
  };
  explicit ScenePanel(std::shared_ptr<views::SceneView> scene, QWidget* parent = nullptr,
                      Structures structures = Structures::Here);
  ~ScenePanel() override;

  /// Sets the case whose histogram is shown; null: no case. The owner of the scene sets the scene's own case. If the
  /// case's author chose an appearance for a structure, the structure is drawn with it until the next case. The user's
  /// choices for other structures stay, except that another patient starts with skin and without the CT volume. An
  /// author's colors do not replace the color-blind-safe colors.
  void setCase(std::shared_ptr<const PatientCase> patient);

  HistogramEditor& histogram() { return *histogram_; }

  views::ColourScheme colourScheme() const { return scheme_; }
  /// Applies the scheme's colors to all structures, or with the default scheme those of the case.
  void setColourScheme(views::ColourScheme scheme);
  /// Restores the author's appearance, else shows all structures with the scheme's colors and the default opacities.
  void showUsual();

  /// Stores all settings but the clipping plane, which belongs to one patient.
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  /// Emitted when a structure's color has changed in the scene, so that slices can follow.
  void coloursChanged();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildStructures();
  QWidget* buildCt();
  void refresh();
  void scrollToHistogram();
  /// Draws at lower resolution until nothing has changed for a moment.
  void live();
  struct Look {
    views::Colour colour;
    double opacity = 1;
    bool visible = true;
  };
  Look look(std::uint8_t label) const;
  void setLook(std::uint8_t label, const Look& look);
  views::Colour caseColour(std::uint8_t label) const;
  void takeLooks();
  void showAnother();

  std::shared_ptr<views::SceneView> scene_;
  ValueSlider* skin_ = nullptr;
  StructureList* structures_ = nullptr;
  QCheckBox* safeColours_ = nullptr;
  QCheckBox* ct_ = nullptr;
  HistogramEditor* histogram_ = nullptr;
  ClippingControls* clipping_ = nullptr;
  EyeControls* eyes_ = nullptr;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const PatientCase> last_;  ///< the last case that was not null
  std::map<std::uint8_t, Look> own_;         ///< the user's appearance of structures that now have the author's
  views::ColourScheme scheme_ = views::ColourScheme::Usual;
  bool structuresHere_ = true, refreshing_ = false, refreshDue_ = false;
  QTimer rest_;
};

}  // namespace insonate::ui
