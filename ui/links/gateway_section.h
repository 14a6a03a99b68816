// The switch that serves other ground stations and programs through this station (engine::Gateway): at which addresses, with
// which rights, and the connected stations. Each address may have the options of skyseal-cli gateway --serve. Main thread.
#pragma once

#include "ui/links/client_model.h"
#include "ui/links/rights_menu.h"
#include "ui/settings.h"
#include "ui/station_interface.h"

#include <QtWidgets/QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;
class QTreeView;

namespace skyseal::ui {

class GatewaySection : public QWidget
{
    Q_OBJECT

public:
    explicit GatewaySection(StationInterface &station, QWidget *parent = nullptr);

    /// Serves as the settings say, unless it does already.
    void apply(const Serving &serving);
    void showSnapshot(const engine::Snapshot &snapshot);

Q_SIGNALS:
    /// The operator chose this.
    void servingChanged(const skyseal::ui::Serving &serving);
    /// The present rights of other stations in a few words and in a sentence; both empty while they may at most read.
    void sharingChanged(const QString &word, const QString &sentence);

protected:
    void changeEvent(QEvent *event) override;

private:
    void choose();
    void chooseRights(const engine::WriteRights &rights);
    void allowClasses(bool allowed);
    void set(const Serving &serving);
    void serve();
    void showRights();
    void showState(const QString &text, const QColor &color);

    StationInterface &m_station;
    ClientModel m_clients;
    Serving m_serving;
    bool m_open = false;      ///< programs of other computers can become clients
    bool m_isServing = false; ///< switched on, and all addresses are valid
    QCheckBox *m_on;
    QComboBox *m_url;
    QComboBox *m_rights;
    RightsMenu *m_classes;
    QToolButton *m_classesButton;
    QLabel *m_warning, *m_state;
    QTreeView *m_view = nullptr;
};

} // namespace skyseal::ui
