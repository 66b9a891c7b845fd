// Generated from the Java records in rsal/server/message/Messages by PageTypesTest. Do not edit.

export interface Abilities {
  forward: number;
  backward: number;
  sideways: number;
  turn: number;
  behaviors: string[];
  noBehavior: string;
  noGoal: string;
}

export interface Access {
  control: boolean;
}

export interface Added {
  name: string;
}

export interface AgentDetails {
  name: string;
  role: string;
  type: string;
  robot: string;
  status: Status;
  state: string;
  beliefs: Record<string, string>;
  sent: number;
  lastSent: number | null;
  messages: string[];
}

export interface AgentInside {
  agent: string;
  arguments: SettingInfo[];
  status: Status | null;
  state: string;
  shown: BeliefInfo[];
  mind: MindInfo | null;
  program: ProgramInfo | null;
  history: ChangeInfo[];
  mail: MailInfo[] | null;
  talks: TalkInfo[];
  hearings: HearingInfo[];
}

export interface AgentStatus {
  name: string;
  robot: string;
  status: Status;
  state: string;
}

export interface AgentTypeInfo {
  type: string;
  description: string;
  needsRobot: boolean;
  arguments: ArgumentInfo[];
}

export interface AgentTypes {
  types: AgentTypeInfo[];
}

export interface ArgumentInfo {
  name: string;
  kind: ArgumentKind;
  value: string;
  typed: boolean;
  min: number | null;
  max: number | null;
  options: string[];
  unit: string;
  description: string;
}

export type ArgumentKind = 'NUMBER' | 'INTEGER' | 'TEXT' | 'FLAG';

export interface Armed {
  on: number;
  off: string[];
}

export interface BeliefInfo {
  name: string;
  value: string;
}

export interface BlobInfo {
  color: string;
  from: number;
  to: number;
  range: number | null;
}

export interface Box {
  low: number;
  first: number;
  median: number;
  third: number;
  high: number;
  outside: number[];
}

export interface CameraView {
  name: string;
  x: number;
  y: number;
  heading: number;
  fieldOfView: number;
  blobs: BlobInfo[];
}

export interface Cameras {
  cameras: CameraView[];
}

export interface CarriedInfo {
  devices: string[];
  pieces: number[];
  x: number;
  y: number;
  heading: number;
  rise: number;
}

export interface ChangeInfo {
  time: number;
  kind: Kind;
  name: string;
  words: string;
}

export interface Communication {
  communication: HearingInfo[];
}

export type Condition = 'OK' | 'STALE' | 'LOST';

export interface ConfigurationInfo {
  name: string;
  title: string;
  realTime: boolean;
}

export interface Control {
  holder: string | null;
  mine: boolean;
}

export interface ControlWish {
  name: string;
  over: boolean;
}

export interface Details {
  run: number;
  whole: boolean;
  ending: Ending | null;
  robots: RobotDetails[];
  agents: AgentDetails[];
}

export interface DeviceDetails {
  name: string;
  driver: string;
  type: string;
  health: Condition;
  reason: string;
}

export interface DeviceNumbers {
  device: string;
  numbers: NumberInfo[];
}

export interface DrawnMap {
  device: string;
  time: number;
}

export interface EarlierSweep {
  name: string;
  title: string;
  started: string;
  runs: number;
  ended: number;
  command: string;
}

export interface Ending {
  outcome: string;
  simulatedSeconds: number;
  wallSeconds: number;
  eventHash: string;
  metrics: Record<string, number | null>;
  outOfBounds: string[];
  failed: Record<string, string>;
  unhandledGoals: Record<string, string[]>;
  failure: string;
}

export interface EventInfo {
  sequence: number;
  time: number;
  kind: string;
  subject: string;
  text: string;
  said: SaidInfo | null;
}

export interface Events {
  run: number;
  events: EventInfo[];
}

export interface Fact {
  name: string;
  value: string;
  color: string | null;
}

export interface FieldError {
  where: string;
  message: string;
  remedy: string;
}

export interface FieldInfo {
  name: string;
  kind: FieldKind;
  choices: string[];
}

export type FieldKind = 'WORDS' | 'NUMBER' | 'CHOICE' | 'PLACE' | 'PLACES' | 'POSE';

export interface GoalInfo {
  name: string;
  state: Wanted;
  urgency: string;
  plans: string[];
  steps: string[];
  failure: string;
}

export interface GripperInfo {
  name: string;
  x: number;
  y: number;
  heading: number;
  length: number;
  width: number;
  paddleLength: number;
  paddleWidth: number;
  low: number;
  high: number;
  lift: number;
}

export interface HearingInfo {
  sender: string;
  listener: string;
  topic: string;
  heard: number;
  lost: number;
}

export interface HostInfo {
  key: string;
  description: string;
  realTime: boolean;
}

export interface ImageInfo {
  width: number;
  height: number;
  rgb: string;
}

export type Kind = 'DOES' | 'BELIEVES' | 'WANTS';

export interface LightInfo {
  name: string;
  x: number;
  y: number;
  color: string;
}

export interface LinkInfo {
  one: string;
  other: string;
  there: boolean;
  back: boolean;
  saidThere: boolean;
  saidBack: boolean;
}

export interface Links {
  links: LinkInfo[];
  ofChosen: boolean;
}

export interface LookBack {
  live: boolean | null;
  time: number | null;
  step: number | null;
  playing: boolean | null;
  speed: string | null;
}

export interface MailInfo {
  time: number;
  from: string;
  forAll: boolean;
  topic: string;
  words: string;
}

export interface MapInfo {
  name: string;
  width: number;
  height: number;
  resolution: number;
  originX: number;
  originY: number;
  colors: string[];
  wallHeight: number | null;
}

export interface MetricInfo {
  name: string;
  unit: string;
  min: number | null;
  max: number | null;
}

export interface MindInfo {
  beliefs: BeliefInfo[];
  goals: GoalInfo[];
  left: number;
}

export interface MotorsOff {
  all: boolean;
  of: string[];
  switchedOff: string[];
}

export interface MountInfo {
  device: string;
  x: number;
  y: number;
  heading: number;
}

export interface Mounts {
  mounts: MountInfo[];
}

export interface Newcomers {
  run: number;
  robots: RobotInfo[];
}

export interface NumberInfo {
  name: string;
  title: string;
  unit: string;
  value: number | null;
}

export interface OutcomeShare {
  outcome: string;
  count: number;
  low: number | null;
  high: number | null;
}

export interface PastNumbers {
  times: number[];
  values: (number | null)[];
}

export interface PieceInfo {
  color: string | null;
  corners: number[][];
  radius: number;
  low: number;
  high: number;
}

export interface Plan {
  seed: string;
  arguments: ArgumentInfo[];
}

export interface PlanInfo {
  name: string;
  text: string;
}

export interface PlottedNumbers {
  time: number;
  devices: DeviceNumbers[];
}

export interface ProgramInfo {
  rules: string[];
  plans: PlanInfo[];
  left: number;
}

export interface Reach {
  run: number;
  from: number;
  until: number;
  motors: MotorsOff;
}

export interface ReadingInfo {
  device: string;
  facts: Fact[];
  left: number;
  age: number;
  image: ImageInfo | null;
}

export interface Readings {
  readings: ReadingInfo[];
}

export interface RealDetails {
  proxy: boolean;
  silence: number | null;
}

export interface Receipt {
  frame: number | null;
  events: number | null;
  look: LookBack | null;
  token: string | null;
}

export interface RecordingInfo {
  name: string;
  started: string;
  whole: boolean;
  damage: string[];
}

export interface Refused {
  message: string;
  problems: FieldError[];
}

export interface Restart {
  scenario: string | null;
  configuration: string | null;
  arguments: Record<string, string> | null;
  seed: string | null;
  speed: string | null;
  mas: string | null;
  text: string | null;
}

export interface RobotDetails {
  id: string;
  gone: boolean;
  goneFor: number | null;
  inCharge: string;
  behavior: string;
  driver: string;
  stopped: boolean;
  quality: string;
  carried: CarriedInfo[];
  real: RealDetails | null;
  devices: DeviceDetails[];
  maps: DrawnMap[];
}

export interface RobotInfo {
  id: string;
  role: string;
  color: string;
  model: string;
  footprint: number[][];
  pieces: PieceInfo[];
  gripper: GripperInfo | null;
  light: LightInfo | null;
}

export interface RobotModelInfo {
  model: string;
  title: string;
}

export interface RobotModels {
  models: RobotModelInfo[];
}

export interface RobotStatus {
  id: string;
  role: string;
  x: number | null;
  y: number | null;
  heading: number | null;
  gone: boolean;
  stopped: boolean;
  inCharge: string;
}

export interface Routine {
  topics: string[];
  said: RoutineInfo[];
}

export interface RoutineInfo {
  time: number;
  from: string;
  text: string;
  said: SaidInfo;
}

export interface RunInfo {
  number: number;
  process: string;
  scenario: string;
  title: string;
  description: string;
  configuration: string;
  configurations: ConfigurationInfo[];
  arguments: ArgumentInfo[];
  seed: string;
  step: number;
  map: MapInfo;
  robots: RobotInfo[];
  metrics: MetricInfo[];
  mas: string;
  edited: boolean;
  recording: RecordingInfo | null;
}

export interface SaidInfo {
  to: string;
  topic: string;
  conversation: string;
  protocol: string;
  act: string;
}

export interface SayableInfo {
  topic: string;
  fields: FieldInfo[];
}

export interface Sayables {
  sayable: SayableInfo[];
}

export interface ScenarioInfo {
  id: string;
  title: string;
  description: string;
  configurations: ConfigurationInfo[];
  problem: string;
}

export interface ScenarioText {
  scenario: string;
  file: string;
  text: string;
  saved: string | null;
}

export interface Scenarios {
  scenarios: ScenarioInfo[];
  hosts: HostInfo[];
}

export interface SeatInfo {
  number: number;
  title: string;
  scenario: string;
  configuration: string;
  seed: string;
  typed: Record<string, string>;
  mas: string;
  time: number;
  speed: string;
  paused: boolean;
  stopped: boolean;
  outcome: string;
}

export interface Sent {
  goal: number;
}

export interface SentGoalInfo {
  id: number;
  robot: string;
  x: number;
  y: number;
  heading: number;
  status: string;
  why: string;
  sent: number;
  ended: number | null;
}

export interface ServerMessage {
  run: RunInfo | null;
  newcomers: Newcomers | null;
  things: Things | null;
  details: Details | null;
  events: Events | null;
  reach: Reach | null;
  access: Access | null;
}

export interface SettingInfo {
  name: string;
  value: string;
  fallback: string | null;
  unit: string;
  description: string;
}

export interface SideBySide {
  most: number;
  runs: SeatInfo[];
}

export type Status = 'RUNNING' | 'ENDED' | 'FAILED';

export interface StatusInfo {
  run: number;
  scenario: string;
  configuration: string;
  seed: string;
  time: number;
  paused: boolean;
  stopped: boolean;
  outcome: string;
  robots: RobotStatus[];
  agents: AgentStatus[];
  goals: SentGoalInfo[];
}

export interface Stopped {
  robots: number;
}

export interface SweepCombination {
  label: string;
  ended: number;
  outcomes: OutcomeShare[];
  metrics: Record<string, SweepEstimate>;
}

export interface SweepEstimate {
  count: number;
  measured: number;
  mean: number;
  low: number | null;
  high: number | null;
  box: Box;
}

export interface SweepInfo {
  number: number;
  scenario: string;
  title: string;
  status: SweepStatus;
  problem: string;
  command: string;
  folder: string;
  jobs: number;
  runs: number;
  ended: number;
  broken: number;
  left: number | null;
  metrics: SweepMetric[];
  combinations: SweepCombination[];
}

export interface SweepMetric {
  name: string;
  unit: string;
  horizon: number | null;
}

export interface SweepRunAgain {
  sweep: number;
  run: number;
}

export interface SweepRunInfo {
  run: number;
  seed: string;
  outcome: string;
  reason: string;
  seconds: number | null;
}

export interface SweepRuns {
  runs: SweepRunInfo[];
}

export interface SweepSize {
  combinations: number;
  seeds: number;
  runs: number;
}

export interface SweepState {
  possible: boolean;
  jobs: number;
  newest: SweepInfo | null;
}

export type SweepStatus = 'RUNS' | 'ENDED' | 'STOPPED' | 'FAILED';

export interface SweepWish {
  scenario: string;
  configurations: string[];
  arguments: Record<string, string>;
  seeds: string;
  limit: string;
  jobs: number | null;
}

export interface SweepsBefore {
  sweeps: EarlierSweep[];
}

export interface TalkInfo {
  time: number;
  from: string;
  to: string;
  conversation: string;
  protocol: string;
  act: string;
  words: string;
  times: number;
}

export interface TextCheck {
  configurations: ConfigurationInfo[];
  errors: TextError[];
}

export interface TextError {
  file: string;
  line: number;
  column: number;
  message: string;
  remedy: string;
}

export interface TextToCheck {
  scenario: string | null;
  text: string;
}

export interface TextToSave {
  scenario: string;
  before: string;
  text: string;
}

export interface ThingInfo {
  number: number;
  name: string;
  x: number;
  y: number;
  heading: number;
  height: number;
  pieces: PieceInfo[];
}

export interface Things {
  run: number;
  came: ThingInfo[];
  gone: number[];
  left: number;
}

export interface TopicInfo {
  topic: string;
  said: number;
  heard: number;
  outOfRange: number;
  byChance: number;
  crowded: number;
  byFault: number;
}

export interface Topics {
  topics: TopicInfo[];
}

export interface Trail {
  times: number[];
  xs: number[];
  ys: number[];
  driven: boolean[];
}

export interface Trails {
  robots: Trail[];
}

export type Wanted = 'NOT_WANTED' | 'REACHED' | 'WAITING' | 'PURSUED' | 'SUSPENDED' | 'RESTING';

/** Commands that people give to runs, from OperatorCommands: what each takes and answers. */
export interface Commands {
  /** Pauses simulated time. A run in real time can't be paused. */
  pause: { takes: Record<string, never>; answers: object };
  /** Resumes simulated time. */
  resume: { takes: Record<string, never>; answers: object };
  /** Runs one step while the run is paused. */
  step: { takes: Record<string, never>; answers: object };
  /** Sets the speed of simulated time. */
  speed: { takes: { factor: string }; answers: object };
  /** Ends the run. */
  stop: { takes: Record<string, never>; answers: object };
  /** Sends a robot to a pose. */
  goal: { takes: { robot: string; x: number; y: number; heading: number }; answers: Sent };
  /** Gives a robot a behavior until its next command. */
  behavior: { takes: { robot: string; behavior?: string }; answers: object };
  /** Drives a robot by hand. Repeat it ten times a second: after 0.5 s without a command, the robot stands still; after 5 s, it is given back to its agents. */
  drive: { takes: { robot: string; driver: string; vx?: number; vy?: number; omega?: number }; answers: object };
  /** Gives a robot that was driven by hand back to its agents. */
  release: { takes: { robot: string; driver: string }; answers: object };
  /** Switches off the motors of all robots, in all runs side by side. */
  estop: { takes: Record<string, never>; answers: Stopped };
  /** Switches the motors on after an emergency stop, except of robots that were switched off one by one. */
  rearm: { takes: Record<string, never>; answers: Armed };
  /** Switches the motors of one robot off or on. */
  motors: { takes: { robot: string; on?: boolean }; answers: object };
  /** Moves a robot, or a thing, in the simulated world. Its localizer gets the new pose. */
  place: { takes: { robot: string; x: number; y: number; heading: number }; answers: object };
  /** Sets the pose that a robot's localizer believes. The robot itself does not move. */
  believe: { takes: { robot: string; x: number; y: number; heading: number }; answers: object };
  /** Adds a thing to the simulated world. */
  add: { takes: { kind: 'BOX' | 'BALL'; x: number; y: number; heading: number }; answers: Added };
  /** Adds a robot like another one, with devices and agents, to the simulated world. */
  'add-robot': { takes: { robot: string; x: number; y: number; heading: number }; answers: Added };
  /** Adds a robot of a model, without agents, to the simulated world. */
  'new-robot': { takes: { model: string; x: number; y: number; heading: number }; answers: Added };
  /** Removes a robot with its agents, or a thing, from the simulated world. */
  remove: { takes: { name: string }; answers: object };
  /** Starts an agent of a type that is installed. */
  'new-agent': { takes: { type: string; robot?: string; arguments?: Record<string, string> }; answers: Added };
  /** Starts an agent like another one. */
  'add-agent': { takes: { like: string; robot?: string }; answers: Added };
  /** Restarts an agent that has ended or failed. */
  'start-agent': { takes: { name: string }; answers: object };
  /** Ends an agent. */
  'stop-agent': { takes: { name: string }; answers: object };
  /** Sends a message to agents in the operator's name. */
  say: { takes: { to?: string; topic: string; fields?: Record<string, string> }; answers: object };
}
