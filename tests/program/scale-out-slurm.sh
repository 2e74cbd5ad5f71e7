# examples/scale-out with Slurm daemons started here for one node: the shards have the same findings as one run.
PATH="$PATH:/usr/sbin:/sbin"
for tool in jq slurmctld slurmd sbatch scontrol; do
	need $tool
done
[ "$(id -u)" = 0 ] || skip "slurmd wants root"
scale_out="$(dirname "$LIB")/../../examples/scale-out"
small_machine
awk 'BEGIN { for (i = 0; i < 5000; i++) printf "G0 X%d Z%d\n", i % 203, -(7 * i % 103) }' >long.nc
here=$(hostname -s)
mkdir state spool
cat >slurm.conf <<CONF
ClusterName=test
SlurmctldHost=$here(127.0.0.1)
SlurmUser=root
AuthType=auth/none
CredType=cred/none
SlurmctldPort=$((20000 + $$ % 20000))
SlurmdPort=$((40000 + $$ % 20000))
StateSaveLocation=$PWD/state
SlurmdSpoolDir=$PWD/spool
SlurmctldPidFile=$PWD/slurmctld.pid
SlurmdPidFile=$PWD/slurmd.pid
SlurmctldLogFile=$PWD/slurmctld.log
SlurmdLogFile=$PWD/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
NodeName=$here NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$here Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$PWD/slurm.conf" FIVECHECK
slurmctld -D >slurmctld.out 2>&1 &
control=$!
slurmd -D -N "$here" >slurmd.out 2>&1 &
node=$!
trap 'kill $node $control 2>/dev/null; wait' EXIT
# The job waits until both daemons have found each other, and runs on the node when it is idle.
timeout 300 srun -Q -N 1 true >srun.out 2>&1
if ! sinfo -h -o %t 2>/dev/null | grep -q idle; then
	tail -n 3 slurmctld.out slurmd.out slurmctld.log slurmd.log >&2
	skip "Slurm does not start here"
fi
fivecheck -q -a -f ndjson=whole.json m.xml long.nc 2>/dev/null
timeout 1000 "$scale_out/with-slurm" 3 out -a m.xml long.nc
echo "status $?"
jq -c . out/all.json >a.lines
jq -c . whole.json >b.lines
cmp a.lines b.lines && ls out
