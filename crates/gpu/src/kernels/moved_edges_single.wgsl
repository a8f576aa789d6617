// Compiled from moved.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: c793651271eb566e
// result: 36fba3ebb4d52e34

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) capacity_0 : u32,
    @align(4) primitives_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(0) @group(0) var<storage, read> sides_0 : array<vec4<u32>>;

@binding(2) @group(0) var<storage, read> positions_0 : array<f32>;

@binding(5) @group(0) var<storage, read> others_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> primitives_1 : array<f32>;

@binding(4) @group(0) var<storage, read> tags_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> rough_0 : array<u32>;

fn position_at_0( at_0 : u32) -> vec3<f32>
{
    return vec3<f32>(positions_0[at_0], positions_0[at_0 + u32(1)], positions_0[at_0 + u32(2)]);
}

fn position_0( vertex_0 : u32) -> vec3<f32>
{
    return position_at_0(u32(6) * vertex_0);
}

fn kept_0( v_0 : vec3<f32>) -> vec3<f32>
{
    return min(v_0, vec3<f32>(3.00000000549775576e+38f, 3.00000000549775576e+38f, 3.00000000549775576e+38f));
}

fn remainder_0( vertex_1 : u32) -> vec3<f32>
{
    return position_at_0(u32(6) * vertex_1 + u32(3));
}

fn other_vector_0( at_1 : u32) -> vec3<f32>
{
    return vec3<f32>(others_0[at_1], others_0[at_1 + u32(1)], others_0[at_1 + u32(2)]);
}

fn put_0( at_2 : u32,  v_1 : vec3<f32>)
{
    primitives_1[at_2] = v_1.x;
    primitives_1[at_2 + u32(1)] = v_1.y;
    primitives_1[at_2 + u32(2)] = v_1.z;
    return;
}

fn put_rough_0( row_0 : u32,  edge_0 : u32,  v_2 : vec3<f32>,  word_0 : u32)
{
    var at_3 : u32 = u32(4) * (row_0 * launch_0.primitives_0 + edge_0);
    rough_0[at_3] = (bitcast<u32>((v_2.x)));
    rough_0[at_3 + u32(1)] = (bitcast<u32>((v_2.y)));
    rough_0[at_3 + u32(2)] = (bitcast<u32>((v_2.z)));
    rough_0[at_3 + u32(3)] = word_0;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn moved_edges(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var i_0 : u32 = launch_0.first_0 + thread_0.x;
    if(i_0 >= (launch_0.end_0))
    {
        return;
    }
    var side_0 : vec4<u32> = sides_0[i_0];
    var _S1 : u32 = side_0.x;
    var a_0 : vec3<f32> = position_0(_S1);
    var _S2 : u32 = side_0.y;
    var along_0 : vec3<f32> = kept_0(position_0(_S2) - a_0) + kept_0(remainder_0(_S2) - remainder_0(_S1));
    const first_1 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 0.0f);
    var _S3 : u32 = side_0.z;
    var first_2 : vec3<f32>;
    var second_0 : vec3<f32>;
    if(_S3 != u32(4294967295))
    {
        var _S4 : vec3<f32> = other_vector_0(u32(3) * _S3);
        var _S5 : u32 = side_0.w;
        var second_1 : vec3<f32> = other_vector_0(u32(3) * ((_S5 & (u32(2147483647)))));
        if(((_S5 & (u32(2147483648)))) != u32(0))
        {
            first_2 = (vec3<f32>(0) - second_1);
        }
        else
        {
            first_2 = second_1;
        }
        var _S6 : vec3<f32> = first_2;
        first_2 = _S4;
        second_0 = _S6;
    }
    else
    {
        first_2 = first_1;
        second_0 = first_1;
    }
    var _S7 : u32 = u32(14) * i_0;
    put_0(_S7, a_0);
    put_0(_S7 + u32(3), along_0);
    put_0(_S7 + u32(6), first_2);
    put_0(_S7 + u32(9), second_0);
    var _S8 : f32;
    if((dot(first_2, first_2)) > 0.5f)
    {
        _S8 = 1.0f;
    }
    else
    {
        _S8 = 0.0f;
    }
    primitives_1[_S7 + u32(12)] = _S8;
    if((dot(second_0, second_0)) > 0.5f)
    {
        _S8 = 1.0f;
    }
    else
    {
        _S8 = 0.0f;
    }
    primitives_1[_S7 + u32(13)] = _S8;
    put_rough_0(u32(0), i_0, a_0, tags_0[i_0].w);
    put_rough_0(u32(1), i_0, along_0, tags_0[launch_0.primitives_0 + i_0].w);
    put_rough_0(u32(2), i_0, first_2, u32(0));
    put_rough_0(u32(3), i_0, second_0, u32(0));
    return;
}
