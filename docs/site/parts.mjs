/**
 * What is in the site, in order. Files are those of the repository, which read well there, too; their titles are their
 * first headings.
 */
const docs = (folder, ...names) => names.map((name) => `docs/${folder}/${name}.md`);
const scenarios = (...names) =>
  names.map((name) => `runs/scenarios/src/main/resources/rsal/scenarios/${name}/README.md`);

export const parts = [
  {
    title: 'Tutorials',
    groups: [
      {
        title: 'Tutorials',
        pages: [
          ...docs('tutorials', 'first-scenario', 'first-agent', 'first-agentspeak-robot'),
          'docs/first-hour.md',
        ],
      },
    ],
  },
  {
    title: 'How to',
    groups: [
      { title: 'Install, operate, teach', pages: docs('how-to', 'install', 'python', 'learning', 'network', 'lab', 'troubleshooting') },
      {
        title: 'Robots',
        pages: docs('how-to', 'localization', 'planning', 'avoidance', 'own-controller', 'recoveries', 'traffic', 'mapping', 'player', 'ros2', 'gazebo', 'another-robot-system', 'another-bridge', 'another-world-format', 'another-log-format'),
      },
      {
        title: 'Agents',
        pages: docs(
          'how-to',
          'python-agents',
          'goals-and-plans',
          'conversations',
          'boards',
          'teams',
          'another-mas',
          'jade',
          'jadex',
        ),
      },
      { title: 'Experiments', pages: docs('how-to', 'side-by-side', 'compare', 'record', 'foxglove', 'metrics', 'own-metric', 'own-device') },
    ],
  },
  {
    title: 'Reference',
    groups: [
      { title: 'Commands', pages: docs('reference', 'command-line', 'python', 'python-environments', 'sweeps', 'benchmarks', 'results') },
      {
        title: 'What is there',
        pages: docs('reference', 'agents', 'devices', 'messages', 'robot-models'),
      },
      {
        title: 'What you write',
        pages: docs(
          'reference',
          'scenario-format',
          'worlds',
          'faults',
          'agentspeak',
          'python-api',
          'python-messages',
          'stage-worlds',
          'gazebo-worlds',
          'player-configurations',
        ),
      },
      { title: 'What you see', pages: docs('reference', 'page', 'recordings', 'live-protocol') },
    ],
  },
  {
    title: 'Concepts',
    groups: [{ title: 'Concepts', pages: docs('concepts', 'for-ros', 'for-agents', 'for-simulation', 'limits', 'architecture', 'frames-and-units', 'boards') }],
  },
  {
    title: 'Scenarios',
    groups: [
      {
        title: 'Scenarios',
        pages: scenarios(
          'hunt-and-prey',
          'find-and-collect',
          'foraging',
          'distribution',
          'patrol',
          'rescue',
          'swarm',
          'teleop',
        ),
      },
    ],
  },
  { title: 'Decisions', groups: [{ title: 'Decisions', pages: 'docs/decisions' }] },
];

/** Pages of no part. */
export const others = ['CONTRIBUTING.md', 'agents/own/README.md'];

/** Not for readers: plans are about what is not there yet. */
export const leftOut = ['docs/plans', 'docs/site'];
