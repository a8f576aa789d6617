// Compiled from moved.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: c793651271eb566e
// result: 35d0ddabfee3dabe

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) capacity_0 : u32,
    @align(4) primitives_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(4) @group(0) var<storage, read> tags_0 : array<vec4<u32>>;

@binding(3) @group(0) var<storage, read> faces_0 : array<vec4<u32>>;

@binding(2) @group(0) var<storage, read> positions_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> primitives_1 : array<f32>;

fn position_at_0( at_0 : u32) -> vec3<f32>
{
    return vec3<f32>(positions_0[at_0], positions_0[at_0 + u32(1)], positions_0[at_0 + u32(2)]);
}

fn position_0( vertex_0 : u32) -> vec3<f32>
{
    return position_at_0(u32(6) * vertex_0);
}

fn put_0( at_1 : u32,  v_0 : vec3<f32>)
{
    primitives_1[at_1] = v_0.x;
    primitives_1[at_1 + u32(1)] = v_0.y;
    primitives_1[at_1 + u32(2)] = v_0.z;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn moved_triangles(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var i_0 : u32 = launch_0.first_0 + thread_0.x;
    if(i_0 >= (launch_0.end_0))
    {
        return;
    }
    var _S1 : vec4<u32> = faces_0[tags_0[i_0 / u32(4)][i_0 % u32(4)]];
    var k_0 : u32 = u32(0);
    for(;;)
    {
        if(k_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        put_0(u32(9) * i_0 + u32(3) * k_0, position_0(_S1[k_0]));
        k_0 = k_0 + u32(1);
    }
    return;
}
