// A sweep as the windows see it: what they may ask and what they hear. The application puts the runner behind it.
#pragma once

#include "core/experiment/results.h"

#include <QtCore/QObject>
#include <QtCore/QString>

#include <memory>

namespace skyseal::ui {

/// What is to be measured.
struct SweepOrder
{
    experiment::Plan plan;
    bool ownVehicle = false; ///< on a simulated vehicle and an agent of its own; the connected link is left alone
};

/// Where a sweep stands.
struct SweepProgress
{
    std::size_t done = 0, runs = 0;
    double remaining = 0; ///< seconds
};

/// Lives on the GUI thread; commands return at once.
class SweepInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Why there can be no vehicle of its own; empty when there can.
    virtual QString whyNoOwnVehicle() const = 0;
    virtual void start(const SweepOrder &order) = 0;
    /// The link goes back to its suite, then finished() comes.
    virtual void cancel() = 0;
    /// Writes the files of these results into a folder that is made for them; saved() comes.
    virtual void save(const experiment::Results &results, const QString &folder) = 0;

Q_SIGNALS:
    void runBegan(const skyseal::experiment::Run &run, const skyseal::ui::SweepProgress &progress);
    void sampleTaken(const skyseal::experiment::Sample &sample, const skyseal::ui::SweepProgress &progress);
    /// `problem` is a sentence when it was not carried out whole.
    void finished(std::shared_ptr<const skyseal::experiment::Results> results, const QString &problem);
    /// `problem` says what is missing, or, when nothing was `written`, why.
    void saved(const QString &folder, bool written, const QString &problem);
};

} // namespace skyseal::ui
