#!/bin/sh
# Runs the check of the workflow on a Slurm cluster of one node: this machine, for as long as the check takes. Needs root and
# Debian's packages slurm-wlm and munge. What it writes is in a folder of its own, but for one link in /etc/slurm: jobs do not
# inherit where the configuration is. Neither that nor a service is left behind.
set -eu
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null || { echo "skipped: $program was not found (in Debian slurm-wlm and munge)"; exit 0; }
done
[ "$(id -u)" -eq 0 ] || { echo 'skipped: a node of Slurm needs root'; exit 0; }

config=/etc/slurm/slurm.conf
if [ -e "$config" ]; then
  echo "skipped: this machine has a Slurm of its own, $config: pass its profile to scripts/workflow.py"
  exit 0
fi

home=$(mktemp -d)
trap 'kill $(cat "$home"/*.pid 2>/dev/null) 2>/dev/null || true; sleep 1; rm -rf "$home" "$config"' EXIT
trap 'exit 1' INT TERM
mkdir -p "$home/state" "$home/spool" /etc/slurm
ln -s "$home/slurm.conf" "$config"
node=$(hostname -s)
cat > "$config" <<END
ClusterName=check
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
AuthInfo=socket=$home/munge.socket
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MinJobAge=3600
ReturnToService=2
StateSaveLocation=$home/state
SlurmdSpoolDir=$home/spool
SlurmctldPidFile=$home/slurmctld.pid
SlurmdPidFile=$home/slurmd.pid
SlurmctldLogFile=$home/slurmctld.log
SlurmdLogFile=$home/slurmd.log
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=2000 State=UNKNOWN
PartitionName=check Nodes=$node Default=YES MaxTime=INFINITE State=UP
END
head -c 1024 /dev/urandom > "$home/munge.key"
chmod 600 "$home/munge.key"
munged --force --key-file="$home/munge.key" --socket="$home/munge.socket" --pid-file="$home/munged.pid" \
  --log-file="$home/munged.log" --seed-file="$home/munged.seed"
slurmctld || { tail -n 20 "$home"/*.log; exit 1; }
slurmd || { tail -n 20 "$home"/*.log; exit 1; }
for _ in $(seq 30); do
  sinfo --noheader --format %t 2>/dev/null | grep -q idle && break
  sleep 1
done
sinfo --noheader --format %t | grep -q idle || { tail -n 20 "$home"/*.log; exit 1; }
sbatch --version
# A job of the check takes seconds: it is asked for sooner than on a busy cluster. There is no accounting to ask.
python3 scripts/workflow.py --workflow-profile workflow/profiles/slurm --slurm-init-seconds-before-status-checks 5 \
  --slurm-status-command squeue "$@"
