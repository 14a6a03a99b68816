// A three-cell lithium battery: voltage by charge, sag under load, and the readings of a power module.
#pragma once

namespace skyseal::sim {

class Battery
{
public:
    /// `capacity` in mAh.
    explicit Battery(double capacity = 3300) : m_capacity(capacity) {}

    /// A new or recharged battery; `charge` in [0, 1].
    void replace(double capacity, double charge);

    /// Charges or drains the battery so that it has this voltage (V) at rest, as far as its charge goes.
    void setRestVoltage(double voltage);

    /// Draws current for `dt` seconds at a mean rotor thrust in [0, 1]; `armed` rotors idle even at no thrust.
    void step(double dt, double thrust, bool armed);

    double voltage() const { return m_voltage; }   ///< V, under load
    double current() const { return m_current; }   ///< A
    double consumed() const { return m_consumed; } ///< mAh since it was put in
    double energy() const { return m_energy; }     ///< J since it was put in
    /// Percent left as a fuel gauge counts it, 0 to 100.
    double percent() const;
    /// Voltage at the rotors, relative to a full battery at rest.
    double supply() const { return m_voltage / kFull; }

private:
    static constexpr double kFull = 12.6;
    double restVoltage() const;

    double m_capacity;
    double m_consumed = 0;
    double m_energy = 0;
    double m_current = 0;
    double m_voltage = kFull;
};

} // namespace skyseal::sim
