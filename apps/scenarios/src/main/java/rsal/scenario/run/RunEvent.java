package rsal.scenario.run;

import java.time.Duration;

/// Something that happened in a run, in words for people.
///
/// @param sequence from 1, without gaps
/// @param time since the run's start
/// @param kind `run`, `agent`, `message`, `goal`, `caught`, `collision`, `operator`, `hand`, `health`
/// or `fault`
/// @param subject name of the robot, agent or device it is about; empty for the run itself
public record RunEvent(long sequence, Duration time, String kind, String subject, String text) {}
