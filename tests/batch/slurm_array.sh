#!/usr/bin/env bash
# A batch as a job array of Slurm, which runs on this machine alone, and merged: the same bytes as of one process.
#   tests/batch/slurm_array.sh PROGRAM
# Needs the packages slurm-wlm and munge to be installed, not to be set up, and an administrator's rights.
set -euo pipefail
replan=$(realpath "$1")
experiment=$(realpath "$(dirname "$0")/experiment.json")
work=$(mktemp -d)
export SLURM_CONF=$work/slurm.conf
host=$(hostname -s)
daemons=()
leave() {
  local status=$?
  for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
  wait 2>/dev/null || true
  [[ $status -eq 0 ]] || tail -n 20 "$work"/*.log >&2 || true
  rm -rf "$work"
}
trap leave EXIT
cd "$work"
mkdir state spool

cat >"$SLURM_CONF" <<CONF
ClusterName=alone
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
SwitchType=switch/none
MpiDefault=none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmctldPort=27017
SlurmdPort=27018
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
slurmctld -D >slurmctld.log 2>&1 &
daemons+=($!)
slurmd -D >slurmd.log 2>&1 &
daemons+=($!)
for _ in $(seq 100); do
  sinfo --noheader --format %t 2>/dev/null | grep -q idle && break
  sleep 0.2
done
sinfo --noheader --format 'Slurm: %N is %t'

cat >batch.sh <<BATCH
#!/bin/sh
#SBATCH --array=1-4
#SBATCH --cpus-per-task=1
#SBATCH --output=$work/part-%a.out
"$replan" batch "$experiment" --shard "\$SLURM_ARRAY_TASK_ID/4" --out "$work/part-\$SLURM_ARRAY_TASK_ID"
BATCH
sbatch --wait batch.sh
"$replan" merge part-? -o merged >/dev/null
"$replan" batch "$experiment" --out whole >/dev/null
cmp whole/results.csv merged/results.csv
cmp whole/results.json merged/results.json
echo "The same bytes, as a job array of four and as one process."
