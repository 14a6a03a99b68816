// The list of links, with buttons to add and remove one.
#pragma once

#include "ui/links/link_model.h"
#include "ui/scene.h"

#include <QtWidgets/QWidget>

class QPushButton;
class QTreeView;

namespace skyseal::ui {

class LinksPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LinksPanel(StationPort &station, QWidget *parent = nullptr);

    void showScene(const Scene &scene);

Q_SIGNALS:
    void addWanted();

private:
    StationPort &m_station;
    LinkModel m_model;
    QTreeView *m_view;
    QPushButton *m_remove;
    double m_shownAt = -1;
};

} // namespace skyseal::ui
