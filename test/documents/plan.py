"""How the documents' commands are run where it takes more than to run them."""

# An entry is the beginning of a command without its comment; of several that fit the longest counts. A line's end in
# it is the command's end.

# Commands that are not run, and why. Of these the test sees that the program, its options, and the files that they
# name are there.
NOT_RUN = {
    './scripts/demo': 'installs packages and builds; demo.test launches the same',
    './scripts/python': 'installs packages and builds',
    './scripts/test': 'installs packages, builds, and runs this test',
    './scripts/fuzz': 'builds with clang; minutes',
    'studies/work_precision.py': 'forty minutes',
    'apt-get': 'installs packages',
    'cp -r /usr/share': 'of the packages that are not installed; the test packages uses them',
    'python3 -m venv': 'builds; minutes',
    'scripts/build': 'minutes',
    './scripts/build': 'minutes',
    './scripts/package': 'minutes; the test packages installs them',
    'studies/compare_peers.py': 'ten minutes',
    'rosrun ratchet_sieve sieve_run config/paper_fig8.yaml --duration': 'a minute each',
    'printf': 'needs two other machines; many_machines_test does the same',
    'seq 8': 'needs two other machines; many_machines_test does the same',
    'mkdir -p ~/feeder_ws': 'builds; the test foreign_package does the same',
    'cd ~/feeder_ws': 'builds; the test foreign_package does the same',
    'roslaunch my_feeder': 'of the package that is not built',
    'rostest my_feeder': 'of the package that is not built',
    'sbatch': 'needs a cluster; many_machines_test does the same',
    'rosrun ratchet_sieve sieve_sweep merge': 'merges what the command before it has run',
    'rosrun ratchet_sieve sieve_sweep report fig9.yaml --check-floor':
        'needs all seeds of a setting; SieveSweep.ChecksTheFloor does the same',
}

# Commands that go on, in a terminal of their own: the topic on which a message says that they are up, or the results
# file that gets more results, or None: they print something. They are then ended by Ctrl-C, but for STAYING ones, which
# stay until the next block of commands, or until their recording is read.
GOES_ON = {
    'roslaunch ratchet_sieve sieve.launch paused:=true': '/sieve/scene',
    'roslaunch ratchet_sieve sieve.launch scene:=$PWD/config/seek.yaml name:=s1': '/s1/scene',
    'roslaunch ratchet_sieve sieve.launch scene:=$PWD/config/seek.yaml name:=s2': '/s2/scene',
    'roslaunch ratchet_sieve sieve.launch': '/sieve/statistics',
    'roslaunch ratchet_sieve replay.launch': '/sieve_display/markers',
    'ROS_NAMESPACE=line2 roslaunch ratchet_sieve seek.launch': '/line2/seek/trials',
    'roslaunch ratchet_sieve seek.launch': '/seek/trials',
    'rostopic echo': None,
    'rosrun ratchet_sieve sieve_sweep run fig9.yaml\n': 'fig9.db',
    'rosrun ratchet_sieve sieve_sweep run config/sweeps/seek.yaml --db seek.db': 'seek.db',
}
STAYING = ['paused:=true', 'name:=s1', 'name:=s2', 'disturb:=true', 'line2', 'exit_at_end:=false']
READS_RECORDING = ['rosrun ratchet_sieve sieve_analyze', 'rosrun ratchet_sieve sieve_resimulate']

# What a document takes for granted before a command.
BEFORE = {
    'rosservice call /sieve/pause_physics': 'roslaunch ratchet_sieve sieve.launch exit_at_end:=false',
    # Some of the cases that take nine minutes.
    'rosrun ratchet_sieve sieve_sweep run fig9.yaml\n':
        "sed 's/{from[^}]*count: 61}/[0.2]/; s/count: 32/count: 1/' fig9.yaml > some.yaml && "
        'rosrun ratchet_sieve sieve_sweep run some.yaml --db fig9.db',
}

# Where blocks of YAML are saved, by the beginning of their text.
SAVED = {
    'scene: paper_fig9.yaml\n': 'config/sweep.yaml',
    'base: {teeth: 30, inclination: 0.2': 'mine.yaml',
    'base: {teeth: 20': 'first.yaml',
    'base: {teeth: 30, tooth_height: 0.014': 'stage.yaml',
}

# What is shortened in code and commands: texts of it, and what is run in their place. Searches end where they know their
# best roughly; a calibration is of short runs, with which its counts do not agree.
SHORTENED = {
    '(15, 48)}))': '(40, 48)}, within=0.2))',
    '(15, 48)}, seed=1))': '(26, 48)}, within=0.05, seed=1))',
    'within=0.02)': 'within=0.05)',
    '{"base.inclination": (0.0, 0.35)})\n': '{"base.inclination": (0.0, 0.35)}, within=0.05)\n',
    '--over base.frequency=15:48 --html': '--over base.frequency=15:48 --within 0.05 --html',
    '--budget "20 s"': '--within 0.05',
    '"duration": 120,': '"duration": 6,',
    # Its settings are by chance: none of these fills up.
    '(5.0, 40.0)}, trials=24, storage': '(12.0, 20.0)}, trials=3, storage',
    '(5.0, 40.0)}, trials=24': '(25.0, 40.0)}, trials=3',
}
