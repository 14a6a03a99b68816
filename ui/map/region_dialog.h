// The dialog that fetches the area in view from the tile server into an MBTiles file, for flights without a network.
#pragma once

#include "ui/tiles/tile_loader.h"

#include <QtWidgets/QDialog>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace skyseal::ui {

class RegionDialog : public QDialog
{
    Q_OBJECT

public:
    static constexpr qint64 kMostTiles = 20'000;

    /// `metres`: the area, of the projection. `level`: at which it is looked at. `loader` must outlive the dialog.
    RegionDialog(TileLoader &loader, const MapSource &source, const QRectF &metres, int level, QWidget *parent = nullptr);

    void done(int result) override;

Q_SIGNALS:
    /// The operator wants the map to show this file.
    void useRequested(const QString &file);

private:
    void browse();
    void start();
    void showProgress(const RegionProgress &progress);
    void showEnd(const RegionEnd &end);
    /// Counts the tiles and says why they cannot be fetched.
    void refresh();
    TileRegion region() const;

    TileLoader &m_loader;
    const QString m_forbidden; ///< why this server's tiles must not be fetched; empty if they may
    const QRectF m_metres;
    bool m_running = false;
    QString m_file; ///< the finished one
    QSpinBox *m_from, *m_to;
    QLineEdit *m_path;
    QPushButton *m_browse, *m_start, *m_use, *m_cancel;
    QProgressBar *m_bar;
    QLabel *m_state;
};

} // namespace skyseal::ui
