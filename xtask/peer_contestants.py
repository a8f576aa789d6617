"""The contestants of peers.py: one program with one method and one number of samples, and how
they run in turn."""

import os
import subprocess
import sys
import time

import numpy as np

# Samples per pixel from which capwalk's set-up is found.
FEW = 2


class Contestant:
    """One way to an image or a vector: runs of it, and how long they took."""

    def __init__(self, **about):
        self.about = about
        self.results = []
        self.times = []

    def measure(self, seed):
        seconds, numbers = self.run(seed)
        self.times.append(seconds)
        self.results.append(numbers)

    def row(self, **found):
        """What there is to say about it."""
        return {**self.about, "seconds": self.seconds(), **self.set_up(), **found}


def in_turn(contestants, budget, runs):
    for contestant in contestants:
        contestant.warm_up()
    seed = 0
    for _ in range(budget.rounds):
        for contestant in contestants:
            for run in range(runs):
                contestant.measure(seed + run)
        seed += runs


class Capwalk(Contestant):
    """A command of capwalk, and what is read from its file."""

    def __init__(self, plan, command, read, seconds, **about):
        super().__init__(program="capwalk", **about)
        self.start = [plan["capwalk"], command[0], plan["file"], *command[1:]]
        self.output = os.path.join(plan["folder"], "capwalk.npz")
        self.read = read
        self.least = seconds
        self.few = []

    def call(self, spp, seed, threads=1):
        """Seconds of the CPU, and what was read."""
        numbers = ["--spp", str(spp), "--seed", str(seed), "--threads", str(threads)]
        command = [*self.start, *numbers, "-o", self.output]
        with open(self.output + ".txt", "w+") as text:
            child = subprocess.Popen(command, stdout=text, stderr=text)
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
            if child.returncode != 0:
                text.seek(0)
                sys.exit(f"{' '.join(command)}\nended with {child.returncode}:\n{text.read()}")
        return usage.ru_utime + usage.ru_stime, self.read(np.load(self.output))

    def warm_up(self):
        spp = FEW
        start, _ = self.call(spp, 0)
        # Where the start takes long, its spread would hide a short run.
        least = start + max(self.least, start / 2)
        while spp == FEW or self.call(spp, 0)[0] < least:
            spp *= 2
        self.about["spp"] = spp

    def long(self, budget):
        """Samples per pixel of a reference."""
        self.warm_up()
        return self.about["spp"] * budget.reference

    def run(self, seed):
        self.few.append(self.call(FEW, seed)[0])
        return self.call(self.about["spp"], seed)

    def per_spp(self):
        return (min(self.times) - min(self.few)) / (self.about["spp"] - FEW)

    def seconds(self):
        return self.per_spp() * self.about["spp"]

    def set_up(self):
        return {"set_up": min(self.few) - self.per_spp() * FEW}


class Mitsuba(Contestant):
    """A call of Mitsuba, whose first run is not counted."""

    def __init__(self, call, samples, pixels, **about):
        spp = max(1, samples // pixels)
        super().__init__(program="mitsuba", spp=spp, **about)
        self.call = call

    def run(self, seed):
        return self.call(self.about["spp"], seed)

    def warm_up(self):
        self.first = self.run(0)[0]

    def seconds(self):
        return min(self.times)

    def set_up(self):
        return {"first_run": self.first - self.seconds()}


def timed(work, clock=time.process_time):
    """Seconds, by default of the CPU, and the result as an array."""
    start = clock()
    result = np.array(work(), dtype=np.float64)
    return clock() - start, result
