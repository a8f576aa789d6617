// Compiled from queries.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 4d0f77661657a545
// result: fedcaa2294f2a42a

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) capacity_0 : u32,
    @align(4) primitives_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(6) @group(0) var<storage, read_write> answers_0 : array<u32>;

var<private> _S1 : u32;

fn of_lane_0( value_0 : u32,  other_0 : u32) -> u32
{
    ;
    var _S2 : u32 = subgroupShuffle(value_0, u32((((_S1 & (u32(4294967288)))) | (other_0))));
    return _S2;
}

@compute
@workgroup_size(64, 1, 1)
fn eights(@builtin(global_invocation_id) thread_0 : vec3<u32>, @builtin(subgroup_invocation_id) _builtinWaveLaneIndex_0 : u32)
{
    _S1 = _builtinWaveLaneIndex_0;
    var other_1 : u32 = u32(0);
    var right_0 : u32 = u32(0);
    for(;;)
    {
        if(other_1 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S3 : u32 = thread_0.x;
        var _S4 : u32 = of_lane_0(_S3, other_1);
        if(_S4 == ((((_S3 & (u32(4294967288)))) | (other_1))))
        {
            right_0 = right_0 + u32(1);
        }
        other_1 = other_1 + u32(1);
    }
    var _S5 : u32 = thread_0.x;
    if(_S5 < (launch_0.end_0))
    {
        answers_0[_S5] = right_0;
    }
    return;
}
